#include "stepping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "creature_numbers.hpp"
#include "land.hpp"
#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

constexpr std::size_t kLegs = 8;

/// An upright wall that faces along z: rock where x < 0, glass beyond.
mesh::RawMesh half_glass() {
    mesh::RawMesh raw;
    raw.points = {{-1, -1, 0}, {0, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
    raw.material_names = {"rock", "glass"};
    raw.add_polygon({0, 1, 4, 3}, 0);
    raw.add_polygon({1, 2, 5, 4}, 1);
    return raw;
}

surface::GripOverrides glass_is_slippery() {
    surface::GripOverrides grips;
    grips.materials = {{0.8, true}, {0.1, false}};
    return grips;
}

Conduct standing_upright() {
    Conduct conduct = walking(huntsman());
    conduct.pace.top_speed = 0;
    conduct.gravity = {0, -9.81, 0};
    return conduct;
}

std::vector<double> numbers_of(CreatureState& state) {
    std::vector<double> numbers(count_numbers(kLegs));
    write_numbers(state, kLegs, numbers.data());
    return numbers;
}

}  // namespace

TEST_CASE("a foot that finds nothing searches, and stands as soon as there is something", "[unit]") {
    constexpr std::uint64_t kFrames = 180;
    const Land wall(half_glass(), glass_is_slippery()), rock(half_glass());
    const Conduct conduct = standing_upright();
    const RandomStream random(1, "searching");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(wall.surface(), conduct, wall.stand({0.015, 0, 0}, {0, 0, 1}, {1, 0, 0}), state);
    const std::array<std::size_t, 2> searching{0,
                                               1};  // the foremost: they do not turn back so far as to the rock
    Vec3 low = state.feet[0].place, high = low;
    for (std::uint64_t i = 0; i < kFrames; ++i) {
        advance_creature(wall.surface(), conduct, {random, {}}, kFrame, state, measures);
        const BodyPose body = pose_of(conduct, state);
        for (const std::size_t leg : searching) {
            const Limb& limb = huntsman().limbs[leg];
            CHECK(state.progress[leg] >= 0);  // nobody relies on it
            CHECK_FALSE(state.feet[leg].holds);
            CHECK(state.feet[leg].place.z > 0);  // in the air
            CHECK(distance(state.feet[leg].swing.end, to_world(body, limb.base)) <= limb.leg.length);
        }
        const Vec3& place = state.feet[0].place;
        low = {std::min(low.x, place.x), std::min(low.y, place.y), 0};
        high = {std::max(high.x, place.x), std::max(high.y, place.y), 0};
    }
    CHECK(measures.searches > std::size_t{2} * 3 * 7);  // each in an eighth of a second
    CHECK(measures.feet_down <= kFrames * (kLegs - 2));
    CHECK(measures.feet_down >= kFrames * 4);
    CHECK(measures.worst_slip == 0);
    const double leg = huntsman().limbs[0].leg.length;
    CHECK(high.x - low.x > 0.3 * leg);
    CHECK(high.y - low.y > 0.3 * leg);
    for (int i = 0; i < 30; ++i)
        advance_creature(rock.surface(), conduct, {random, {}}, kFrame, state, measures);
    for (std::size_t each = 0; each < kLegs; ++each) {
        CHECK(state.feet[each].holds);
        CHECK(state.progress[each] < 0);
    }
}

TEST_CASE("legs that are solved side by side step as those solved one after the other, to the bit", "[unit]") {
    const Land room(mesh::room(0.5, 4));
    std::vector<Leg> legs;
    for (const Limb& limb : huntsman().limbs) legs.push_back(limb.leg);
    const LegLanes lanes(legs);
    const Conduct one_by_one = walking(huntsman());
    Conduct side_by_side = one_by_one;
    side_by_side.lanes = &lanes;
    const RandomStream random(7, "lanes");
    CreatureMeasures measures;
    CreatureState first, second;
    const Footing ground = room.stand({0.2, -0.25, 0}, {0, 1, 0}, {1, 0, 0.3});
    place_creature(room.surface(), one_by_one, ground, first);
    place_creature(room.surface(), side_by_side, ground, second);
    for (int i = 0; i < 900; ++i) {
        advance_creature(room.surface(), one_by_one, {random, {}}, kFrame, first, measures);
        advance_creature(room.surface(), side_by_side, {random, {}}, kFrame, second, measures);
    }
    CHECK(numbers_of(first) == numbers_of(second));
}

TEST_CASE("whatever solves its legs, a huntsman walks on its feet", "[unit]") {
    const Land cube(mesh::cube(0.3, 4));
    for (const LegSolver& solver : leg_solvers()) {
        INFO(solver.name);
        Conduct conduct = walking(huntsman());
        conduct.solver = &solver;
        const CreatureMeasures measures = wandered(cube, conduct, 1, {0, 1, 0}, 1);
        CHECK(static_cast<double>(measures.feet_down) > 5.0 * static_cast<double>(measures.frames));
        CHECK(measures.forced_steps < measures.steps / 10);
        CHECK(measures.worst_reach <= 1e-6);
    }
}

TEST_CASE("legs step off their time as far as jitter lets them, each time otherwise", "[unit]") {
    const Land floor(mesh::cube(20, 2));
    Conduct conduct = walking(huntsman());
    conduct.rests = false;
    conduct.jitter = 0.05;
    const RandomStream random(1, "jitter");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(floor.surface(), conduct, floor.stand({0, 10, 0}, {0, 1, 0}, {1, 0, 0}), state);
    std::array<double, kLegs> low{}, high{};
    for (int i = 0; i < 3600; ++i) {
        advance_creature(floor.surface(), conduct, {random, {}}, kFrame, state, measures);
        for (std::size_t leg = 0; leg < kLegs; ++leg) {
            double off = state.start[leg] - start_of(*conduct.gait, leg, kLegs);
            off -= std::round(off);
            CHECK(std::abs(off) <= 0.05 + 1e-12);
            low[leg] = std::min(low[leg], off);
            high[leg] = std::max(high[leg], off);
        }
    }
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
        CHECK(low[leg] < -0.03);
        CHECK(high[leg] > 0.03);
    }
    CHECK(measures.forced_steps < measures.steps / 20);
}

TEST_CASE("who hunts stalks and runs, who wanders walks, and a foot that finds nothing reaches about",
          "[unit]") {
    const auto named = [](const Foot& foot) { return stride_paths()[foot.path].name; };
    Conduct conduct = walking(huntsman());
    conduct.path = nullptr;
    const Land floor(mesh::cube(20, 2));
    const auto path_at = [&](double share, double pursue) {
        conduct.behaviors.pursue = pursue;
        CreatureState state;
        CreatureMeasures measures;
        place_creature(floor.surface(), conduct, floor.stand({0, 10, 0}, {0, 1, 0}, {1, 0, 0}), state);
        state.ground.velocity = {share * conduct.pace.top_speed, 0, 0};
        for (int i = 0; i < 20; ++i)
            step_feet(floor.surface(), conduct, RandomStream(1, "paths"), kFrame, state, measures);
        return named(state.feet[0]);
    };
    CHECK(path_at(0.9, 0) == "cycloid");
    CHECK(path_at(0.9, 1) == "arc");
    CHECK(path_at(0.7, 1) == "cycloid");
    CHECK(path_at(0.3, 1) == "creep");
    const Land glass(half_glass(), glass_is_slippery());
    CreatureState state;
    conduct.gravity = {0, -9.81, 0};
    place_creature(glass.surface(), conduct, glass.stand({0.015, 0, 0}, {0, 0, 1}, {1, 0, 0}), state);
    CHECK(named(state.feet[0]) == "reach");
    conduct.path = find_stride_path("arc");
    place_creature(glass.surface(), conduct, glass.stand({0.015, 0, 0}, {0, 0, 1}, {1, 0, 0}), state);
    CHECK(named(state.feet[0]) == "arc");
}

TEST_CASE("a foot that its leg no longer reaches does not count as one that stands", "[unit]") {
    const Land floor(mesh::cube(2, 2));
    const Conduct conduct = walking(huntsman());
    CreatureState state;
    CreatureMeasures measures;
    place_creature(floor.surface(), conduct, floor.stand({0, 1, 0}, {0, 1, 0}, {1, 0, 0}), state);
    state.shift = {0, 1, 0};
    step_feet(floor.surface(), conduct, RandomStream(1, "torn"), kFrame, state, measures);
    CHECK(measures.forced_steps >= 4);
    CHECK(measures.feet_down == 0);
}

TEST_CASE("a foot is strained by how far it is from where it expected to stand, or its leg by its length",
          "[unit]") {
    const Limb& limb = huntsman().limbs[0];
    const BodyPose body{{0, 0.01, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Pace pace{0.02, 5, 0.65};
    Foot foot;
    foot.home = limb.stance;
    foot.place = to_world(body, limb.stance);
    CHECK(strain_of(limb, body, pace, foot) < 0.8);
    const double about = 1.3 * 0.65 * 0.02 / 2 + 0.15 * limb.leg.length;  // at which it steps out of turn
    foot.place = to_world(body, limb.stance - Vec3{about, 0, 0});
    CHECK(strain_of(limb, body, pace, foot) == Approx(1));
    foot.home = from_world(body, foot.place);  // it came down there: on other ground
    CHECK(strain_of(limb, body, pace, foot) < 0.8);
    const Vec3 out = (limb.stance - limb.base) / norm(limb.stance - limb.base);
    foot.place = to_world(body, limb.base + 0.97 * limb.leg.length * out);
    foot.home = from_world(body, foot.place);
    CHECK(strain_of(limb, body, pace, foot) == Approx(1));
}

TEST_CASE("who turns on the spot steps round with its body, in turn and in balance", "[unit]") {
    const Land floor(mesh::cube(2, 2));
    Conduct conduct = walking(huntsman());
    conduct.rests = false;
    const RandomStream random(1, "turning");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(floor.surface(), conduct, floor.stand({0, 1, 0}, {0, 1, 0}, {1, 0, 0}), state);
    for (int i = 0; i < 1200; ++i) {
        // Creeping, and always wanting to go to its left.
        state.ground.velocity = 0.004 * cross(state.ground.footing.up, state.ground.facing);
        advance_creature(floor.surface(), conduct, {random, {}}, kFrame, state, measures);
        if (i == 60) measures = {};
    }
    CHECK(measures.worst_turn * 60 > 60);  // degrees a second
    CHECK(measures.forced_steps == 0);
    CHECK(measures.unstable_frames == 0);
    CHECK(measures.steps > 200);
}
