#include "pilot.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

Crawler in_a_hurry() {
    Crawler made;
    made.period = 0.5;
    made.effort = {0.2, 3, 1, 4};
    return made;
}

/// To what rounding leaves of times.
bool same(const Effort& a, const Effort& b) {
    const auto near = [](double p, double q) { return std::abs(p - q) < 1e-13; };
    return near(a.strain, b.strain) && near(a.bend, b.bend) && near(a.lift, b.lift) && near(a.turn, b.turn);
}

}  // namespace

TEST_CASE("a straight body looks where it was laid, whatever its length", "[unit]") {
    for (const std::uint32_t segments : {3U, 8U}) {
        const Lattice lattice{1, segments};
        const Build build{segments, 0.3, 0.02, 1, 0, 0};
        const Pose laid{{1, 2, 3}, {0.6, 0, 0.8}, {0, 1, 0}};
        const Pose found = heading_of(lattice, straight_points(lattice, build, {{laid}}), laid.middle);
        CHECK(distance(found.forward, laid.forward) < 1e-12);
        CHECK(distance(found.up, laid.up) < 1e-12);
        CHECK(found.middle == laid.middle);
    }
    const std::vector<Vec3> nowhere(16);
    const Pose found = heading_of({1, 3}, nowhere, {});
    CHECK(norm(found.forward) == 1);  // where nothing tells
    CHECK(norm(found.up) == 1);
}

TEST_CASE("who has nowhere to go goes straight on, who has turns there", "[unit]") {
    Crawler made = in_a_hurry();
    const Pose heading{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    CHECK(own_command(made, heading).pace == 1);
    CHECK(own_command(made, heading).turn == 0);
    made.seek = Vec3{0, 0, -1};  // to the left
    CHECK(own_command(made, heading).turn == 1);
    made.seek.reset();
    made.path = Path{{{0, 0, 0}, {0, 0, 5}}, false, 1};
    CHECK(own_command(made, heading).turn == -1);
}

TEST_CASE("frames go on from each other, and muscles set in over the first period", "[unit]") {
    const Crawler made = in_a_hurry();
    constexpr double kStep = 0.05;
    Pilot pilot;
    Drive before = hold(made, pilot, 0);
    CHECK(same(before.effort[1], {0, 0, 0, 0}));
    CHECK(before.ease[1] == 0);
    for (int frame = 0; frame < 20; ++frame) {
        const double time = frame * kStep;
        const Drive drive = go_on(made, {0.5, -1}, time, kStep, pilot);
        CHECK(drive.cycles[0] == before.cycles[1]);
        CHECK(same(drive.effort[0], before.effort[1]));
        CHECK(drive.ease[0] == Approx(before.ease[1]).margin(1e-15));
        CHECK(drive.cycles[1] - drive.cycles[0] == Approx(0.5 * kStep / made.period));
        before = hold(made, pilot, time + kStep);
        CHECK(same(before.effort[0], drive.effort[1]));
        before = drive;
    }
    CHECK(before.effort[1].strain == made.effort.strain);
    CHECK(before.ease[1] == 1);
    CHECK(pilot.turn < -0.85);  // a tenth of what is left, each frame
    CHECK(pilot.turn > -0.9);
}
