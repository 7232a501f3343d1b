#include "creature.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "creature_numbers.hpp"
#include "land.hpp"
#include "orbweaver/diagnostic.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using land::Land;

namespace {

constexpr double kFrame = 1.0 / 60;

const Species& huntsman() {
    static const Species species = [] {
        Diagnostics faults;
        auto found =
            read_species_file(std::string(ORBWEAVER_SOURCE_DIR) + "/assets/creatures/huntsman.toml", faults);
        REQUIRE(found);
        return *found;
    }();
    return species;
}

Conduct wandering() {
    Conduct conduct;
    conduct.species = &huntsman();
    conduct.gait = find_gait("tetrapod");
    conduct.path = find_stride_path("cycloid");
    conduct.solver = find_leg_solver("half_jacobian");
    conduct.pace = {0.15, 0.01, 0.027, 0.75, 0.62};
    conduct.wander = {1.2, 0.3, 10};
    return conduct;
}

struct Place {
    const char* name;
    mesh::RawMesh mesh;
    Vec3 at, up;
};

std::vector<Place> places() {
    return {{"cube outside", mesh::cube(0.5, 4), {0, 0.25, 0}, {0, 1, 0}},
            {"cube inside", mesh::cube(0.5, 4), {0, -0.25, 0}, {0, 1, 0}},
            {"room", mesh::room(0.5, 4), {0, -0.25, 0}, {0, 1, 0}},
            {"cliff", mesh::cliff(1, 8), {0, 1, 0}, {0, 1, 0}},
            {"sphere inside", mesh::sphere(0.5, 16), {0, -0.25, 0}, {0, 1, 0}},
            {"hills", mesh::height_field(1, 16), {0, 1, 0}, {0, 1, 0}}};
}

}  // namespace

TEST_CASE("a huntsman wanders inside and outside, over edges and up walls, and keeps its feet", "[unit]") {
    constexpr int kMinutes = 2;
    const Conduct conduct = wandering();
    for (const Place& place : places()) {
        INFO(place.name);
        const Land land(place.mesh);
        const RandomStream random(1, place.name);
        CreatureState state;
        CreatureMeasures measures;
        place_creature(land.surface(), conduct, land.stand(place.at, place.up, {1, 0, 0.3}), state);
        for (int i = 0; i < kMinutes * 3600; ++i)
            advance_creature(land.surface(), conduct, {random, {}, 0}, kFrame, state, measures);
        CHECK(measures.lost_frames == 0);
        CHECK(measures.worst_slip == 0);
        CHECK(measures.worst_reach <= 1e-6);  // of leg length
        CHECK(measures.worst_joint <= 0);
        CHECK(measures.worst_penetration <= 0);
        CHECK(measures.worst_turn <= conduct.turn_rate * kFrame * (1 + 1e-9));
        CHECK(measures.distance > kMinutes * 60 * 0.03);  // a fifth of its top speed, pauses counted
        CHECK(static_cast<double>(measures.feet_down) / static_cast<double>(measures.frames) > 5);
        CHECK(measures.forced_steps < measures.steps / 20);
    }
}

TEST_CASE("feet that stand are on the surface to rounding", "[unit]") {
    const Conduct conduct = wandering();
    const Land land(mesh::cube(0.5, 4));
    const RandomStream random(1, "feet");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand({0, 0.25, 0}, {0, 1, 0}, {1, 0, 0.3}), state);
    for (int i = 0; i < 3600; ++i) {
        advance_creature(land.surface(), conduct, {random, {}, 0}, kFrame, state, measures);
        for (std::size_t leg = 0; leg < 8; ++leg) {
            if (state.progress[leg] >= 0 || !state.feet[leg].holds) continue;
            const SurfaceHit hit = land.surface().closest_point(state.feet[leg].place, 1);
            CHECK(hit.distance < 1e-15);
        }
    }
}

TEST_CASE("a creature that was saved and restored walks on as the one that never stopped, to the bit",
          "[unit]") {
    const Conduct conduct = wandering();
    const Land land(mesh::room(0.5, 4));
    const RandomStream random(4, "restored");
    CreatureState whole, second;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand({0, -0.25, 0}, {0, 1, 0}, {1, 0, 0.3}), whole);
    std::vector<double> saved(count_numbers(8)), end(saved.size()), second_end(saved.size());
    for (int i = 0; i < 1200; ++i) {
        if (i == 617) write_numbers(whole, 8, saved.data());
        advance_creature(land.surface(), conduct, {random, {}, 0}, kFrame, whole, measures);
    }
    read_numbers(saved.data(), 8, second);
    for (int i = 617; i < 1200; ++i)
        advance_creature(land.surface(), conduct, {random, {}, 0}, kFrame, second, measures);
    write_numbers(whole, 8, end.data());
    write_numbers(second, 8, second_end.data());
    CHECK(end == second_end);
}

TEST_CASE("who stands has the middle of its body among its feet", "[unit]") {
    const Conduct conduct = wandering();
    const Land land(mesh::room(0.5, 4));
    CreatureState state;
    place_creature(land.surface(), conduct, land.stand({0, -0.25, 0}, {0, 1, 0}, {1, 0, 0}), state);
    CHECK(support_of(conduct, state).margin > 0.01);
    CHECK(support_of(conduct, state).margin < 0.05);
    for (std::size_t leg = 0; leg < 8; leg += 2) state.progress[leg] = 0.5;  // all of one side
    CHECK(support_of(conduct, state).margin < 0);
    for (std::size_t leg = 0; leg < 8; ++leg) state.progress[leg] = 0.5;
    CHECK(support_of(conduct, state).margin < 0);
}
