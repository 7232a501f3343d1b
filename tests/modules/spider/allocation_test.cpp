#include <cstdlib>
#include <new>

#include "land.hpp"
#include "leg_lanes.hpp"
#include "walking.hpp"

namespace {
std::size_t allocations = 0;
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* made = std::malloc(size)) return made;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
void operator delete(void* made) noexcept { std::free(made); }
void operator delete(void* made, std::size_t) noexcept { std::free(made); }

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

TEST_CASE("solving allocates nothing, restarts or not", "[unit]") {
    std::vector<Leg> legs;
    for (const Limb& limb : creature("huntsman").limbs) legs.push_back(limb.leg);
    const LegLanes lanes(legs);
    std::vector<double> angles(lanes.angle_count()), targets(lanes.target_count());
    std::vector<LegResult> results(lanes.size());
    LegPose pose = rest_pose(legs[0]);
    const Vec3 behind{-0.9 * legs[0].length, 0, 0};
    for (std::size_t i = 0; i < lanes.size(); ++i) lanes.set_target(targets, i, behind);
    const std::size_t before = allocations;
    REQUIRE(before > 0);
    int restarts = 0;
    for (const LegSolver& solver : leg_solvers())
        restarts += solver.solve(legs[0], {behind}, {}, pose).restarts;
    lanes.solve(targets, {}, angles, results);
    restarts += results[0].restarts;
    const std::size_t after = allocations;
    CHECK(after == before);
    CHECK(restarts >= 4 * LegSolverOptions{}.restarts);
}

TEST_CASE("a frame of a creature allocates nothing", "[unit]") {
    const land::Land room(mesh::room(0.2, 2));
    const Conduct conduct = walking(huntsman());
    const RandomStream random(1, "frames");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(room.surface(), conduct, room.stand({0, -0.1, 0}, {0, 1, 0}, {1, 0, 0.3}), state);
    const std::size_t before = allocations;
    for (int i = 0; i < 1200; ++i)
        advance_creature(room.surface(), conduct, {random, {}}, kFrame, state, measures);
    const std::size_t after = allocations;
    CHECK(after == before);
}
