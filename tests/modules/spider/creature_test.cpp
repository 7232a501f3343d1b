#include "creature.hpp"

#include <cmath>
#include <string>

#include "creature_numbers.hpp"
#include "keep_off.hpp"
#include "land.hpp"
#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

struct Place {
    const char* name;
    mesh::RawMesh mesh;
    Vec3 at;
    double most_out_of_balance;  ///< of frames
    double most_torn = 0.05;     ///< of steps
};

/// How often a creature may be out of balance depends on how its feet find room: twice what was measured over
/// ten minutes each, three times over (0.6, 0.2, 0.2, 2.7, 0.1, 0.4, 0.1, 0.9 and 17 %).
std::vector<Place> places() {
    return {{"cube outside", mesh::cube(0.5, 8), {0, 0.25, 0}, 0.012},
            {"cube inside", mesh::cube(0.5, 8), {0, -0.25, 0}, 0.005},
            {"room", mesh::room(0.5, 8), {0, -0.25, 0}, 0.005},
            {"cliff", mesh::cliff(0.5, 8), {0, 1, 0}, 0.055},
            {"sphere inside", mesh::sphere(0.5, 8), {0, -0.25, 0}, 0.002},
            {"hills", mesh::height_field(0.5, 8), {0, 1, 0}, 0.01},
            {"torus", mesh::torus(0.5, 8), {0.25, 1, 0}, 0.002},
            {"crates on a floor", land::crates_on_a_floor(), {0, 0, 0}, 0.02},
            {"branch", mesh::branch(0.5, 8), {0, 1, 0}, 0.35, 0.2}};
}

/// m, how deep a body's ellipsoids reach into a cube of that half edge, or out of it: by their own equation.
double depth(const Body& body, const BodyPose& pose, double half, bool outside) {
    const double front = body.thorax.x / 2;
    const std::pair<Vec3, double> parts[] = {
        {body.thorax, 0}, {body.head, front + body.head.x / 2}, {body.abdomen, -front - body.abdomen.x / 2}};
    double deepest = -HUGE_VAL;
    for (const auto& [extents, middle] : parts)
        for (int latitude = -90; latitude <= 90; latitude += 15)
            for (int longitude = 0; longitude < 360; longitude += 15) {
                const double a = latitude * kDegree, b = longitude * kDegree;
                Vec3 at{middle + extents.x / 2 * std::cos(a) * std::cos(b), extents.y / 2 * std::sin(a),
                        extents.z / 2 * std::cos(a) * std::sin(b)};
                if (middle < 0) {  // the abdomen bends where the thorax ends
                    const double x = at.x + front, c = std::cos(pose.bend), s = std::sin(pose.bend);
                    at = {-front + c * x + s * at.y, c * at.y - s * x, at.z};
                }
                const Vec3 p = to_world(pose, at);
                const double within = half - std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
                deepest = std::max(deepest, outside ? within : -within);
            }
    return deepest;
}

}  // namespace

TEST_CASE("a huntsman wanders inside and outside, over edges and up walls, and keeps its feet", "[unit]") {
    constexpr int kMinutes = 2;
    constexpr std::uint64_t kSeeds = 3;
    const Conduct conduct = walking(huntsman());
    for (const Place& place : places()) {
        const Land land(place.mesh);
        double unstable = 0, frames = 0;
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            INFO(place.name << ", " << seed);
            const CreatureMeasures measures = wandered(land, conduct, seed, place.at, kMinutes);
            check_walk(measures, conduct, place.most_torn);
            unstable += static_cast<double>(measures.unstable_frames);
            frames += static_cast<double>(measures.frames);
        }
        INFO(place.name);
        CHECK(unstable <= place.most_out_of_balance * frames);
    }
}

TEST_CASE("nobody gets to the other side of a corner sharper than a right angle, or sticks in it", "[unit]") {
    const Conduct conduct = walking(huntsman());
    const Land cliff(mesh::cliff(0.5, 8));  // y = 0 where x < 0, a wall up to (-0.125, 0.25), and y = 0.25
    const auto is_below = [](const Vec3& p) { return p.y < 0 || (p.y < 0.25 && p.x > -p.y / 2); };
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        INFO(seed);
        const RandomStream random(seed, "corner");
        CreatureState state;
        CreatureMeasures measures;
        place_creature(cliff.surface(), conduct, cliff.stand({-0.05, 0, 0}, {0, 1, 0}, {1, 0, 0.1}), state);
        int below = 0, longest = 0, in_place = 0;
        Vec3 place;
        for (int i = 0; i < 7200; ++i) {
            advance_creature(cliff.surface(), conduct, {random, {}}, kFrame, state, measures);
            const Vec3 body = pose_of(conduct, state).position;
            if (is_below(body)) ++below;
            in_place = distance(body, place) < 0.02 ? in_place + 1 : 0;
            if (in_place == 0) place = body;
            longest = std::max(longest, in_place);
        }
        CHECK(below == 0);
        CHECK(measures.penetrating_frames == 0);
        CHECK(longest < 60 * 8);  // pauses last 3 s
    }
}

TEST_CASE("a body longer than its legs finds room in corners and on cliffs, and does not stick", "[unit]") {
    const Species lizard = creature("lizard");
    const Conduct conduct = walking(lizard);
    const Land room(mesh::room(0.5, 8)), cliff(mesh::cliff(0.5, 8));
    for (const Land* land : {&room, &cliff})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            INFO(seed);
            const Vec3 place = land == &room ? Vec3{0, -0.25, 0} : Vec3{0, 1, 0};
            const CreatureMeasures measures = wandered(*land, conduct, seed, place, 2);
            CHECK(measures.penetrating_frames == 0);
            CHECK(measures.distance > 3);
        }
}

TEST_CASE("no part of a body is in the surface, whichever side of a cube it walks on", "[unit]") {
    const Conduct conduct = walking(huntsman());
    const Land outside(mesh::cube(0.3, 3)), inside(mesh::room(0.3, 3));
    for (const Land* land : {&outside, &inside}) {
        const bool is_outside = land == &outside;
        const RandomStream random(2, "parts");
        CreatureState state;
        CreatureMeasures measures;
        const Vec3 at{0, is_outside ? 0.15 : -0.15, 0};
        place_creature(land->surface(), conduct, land->stand(at, {0, 1, 0}, {1, 0, 0.3}), state);
        double deepest = -HUGE_VAL;
        for (int i = 0; i < 7200; ++i) {
            advance_creature(land->surface(), conduct, {random, {}}, kFrame, state, measures);
            if (i % 4 == 0)
                deepest = std::max(deepest, depth(huntsman().body, pose_of(conduct, state), 0.15, is_outside));
        }
        CHECK(deepest <= 0);
        CHECK(deepest > -0.002);  // it did come near: the test would see it
    }
}

TEST_CASE("who wanders over a floor is in balance, and as often on its feet as its duty factor says",
          "[unit]") {
    const Land floor(mesh::cube(20, 2));
    Conduct conduct = walking(huntsman());
    conduct.pace.slow_duty = conduct.pace.fast_duty = 0.68;
    conduct.rests = false;
    const RandomStream random(5, "floor");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(floor.surface(), conduct, floor.stand({0, 10, 0}, {0, 1, 0}, {1, 0, 0}), state);
    int least_down = 8;
    for (int i = 0; i < 7200; ++i) {
        const std::uint64_t before = measures.feet_down;
        advance_creature(floor.surface(), conduct, {random, {}}, kFrame, state, measures);
        least_down = std::min(least_down, static_cast<int>(measures.feet_down - before));
    }
    CHECK(least_down >= 4);
    CHECK(static_cast<double>(measures.feet_down) / 7200 == Approx(8 * 0.68).epsilon(0.01));
    CHECK(measures.unstable_frames < 72);  // one in a hundred
    CHECK(measures.forced_steps == 0);
}

TEST_CASE("a creature goes where its head looks, or little aside of it", "[unit]") {
    const Land floor(mesh::cube(20, 2));
    const Conduct conduct = walking(huntsman());
    const RandomStream random(6, "heads");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(floor.surface(), conduct, floor.stand({0, 10, 0}, {0, 1, 0}, {1, 0, 0}), state);
    int far_aside = 0, walking_frames = 0;
    for (int i = 0; i < 7200; ++i) {
        advance_creature(floor.surface(), conduct, {random, {}}, kFrame, state, measures);
        const double speed = norm(state.ground.velocity);
        if (speed < 0.01) continue;
        ++walking_frames;
        far_aside += dot(state.ground.velocity, state.forward) < std::cos(30 * kDegree) * speed ? 1 : 0;
    }
    CHECK(walking_frames > 3600);
    CHECK(far_aside < walking_frames / 50);
}

TEST_CASE("feet that stand are on the surface to rounding", "[unit]") {
    const Conduct conduct = walking(huntsman());
    const Land land(mesh::cube(0.5, 4));
    const RandomStream random(1, "feet");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand({0, 0.25, 0}, {0, 1, 0}, {1, 0, 0.3}), state);
    for (int i = 0; i < 3600; ++i) {
        advance_creature(land.surface(), conduct, {random, {}}, kFrame, state, measures);
        for (std::size_t leg = 0; leg < 8; ++leg) {
            if (state.progress[leg] >= 0) continue;
            const SurfaceHit hit = land.surface().closest_point(state.feet[leg].place, 1);
            CHECK(hit.distance < 1e-15);
        }
    }
}

TEST_CASE("a creature that was saved and restored walks on as the one that never stopped, to the bit",
          "[unit]") {
    const Conduct conduct = walking(huntsman());
    const Land land(mesh::room(0.5, 4));
    const RandomStream random(4, "restored");
    CreatureState whole, second;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand({0, -0.25, 0}, {0, 1, 0}, {1, 0, 0.3}), whole);
    std::vector<double> saved(count_numbers(8)), end(saved.size()), second_end(saved.size());
    for (int i = 0; i < 1200; ++i) {
        if (i == 617) write_numbers(whole, 8, saved.data());
        advance_creature(land.surface(), conduct, {random, {}}, kFrame, whole, measures);
    }
    read_numbers(saved.data(), 8, second);
    for (int i = 617; i < 1200; ++i)
        advance_creature(land.surface(), conduct, {random, {}}, kFrame, second, measures);
    write_numbers(whole, 8, end.data());
    write_numbers(second, 8, second_end.data());
    CHECK(end == second_end);
}

TEST_CASE("who hardly turns walks on, and whatever of it is not finite is named", "[unit]") {
    const Land cube(mesh::cube(0.3, 4));
    for (const double rate : {1e-3, 1e-9}) {
        Conduct conduct = walking(huntsman());
        conduct.turn_rate = rate;
        const RandomStream random(1, "slow");
        CreatureState state;
        CreatureMeasures measures;
        place_creature(cube.surface(), conduct, cube.stand({0, 1, 0}, {0, 1, 0}, {1, 0, 0.3}), state);
        for (int i = 0; i < 300; ++i) {
            advance_creature(cube.surface(), conduct, {random, {}}, kFrame, state, measures);
            REQUIRE(not_finite(conduct, state) == nullptr);
        }
        CHECK(measures.worst_turn < 0.01 * kFrame + 1e-6);
    }
    const Conduct conduct = walking(huntsman());
    CreatureState bad;
    CHECK(not_finite(conduct, bad) == nullptr);
    bad.feet[7].place.z = std::nan("");
    CHECK(std::string(not_finite(conduct, bad)) == "a foot");
    bad.turn.up.x = std::nan("");
    CHECK(std::string(not_finite(conduct, bad)) == "position");  // which up leads to
    bad = {};
    bad.forward.y = HUGE_VAL;
    CHECK(std::string(not_finite(conduct, bad)) == "forward");
}

TEST_CASE("who stands has its weight among its feet", "[unit]") {
    const Conduct conduct = walking(huntsman());
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
