#include "journey.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

/// Frames of a tenth of a second; a cycle takes a second at pace 1.
struct Walk {
    Journey journey;
    double time = 0, cycles = 0;
    Vec3 center;

    void go(double seconds, double pace, const Vec3& velocity) {
        for (int i = 0; i < static_cast<int>(10 * seconds + 0.5); ++i) {
            time += 0.1;
            cycles += 0.1 * pace;
            center += 0.1 * velocity;
            journey.go_on(center, time, cycles);
        }
    }
    double speed() const { return journey.speed(center, time); }
    double way() const { return journey.way_a_cycle(center, cycles); }
};

}  // namespace

TEST_CASE("the speed is that over whole cycles, of which the first does not count", "[unit]") {
    Walk walk;
    walk.go(1, 1, {0.01, 0, 0});
    CHECK(walk.journey.way == 0);
    walk.go(3, 1, {0.05, 0, 0});
    CHECK(walk.speed() == Approx(0.05));
    walk.go(0.5, 1, {1, 0, 0});  // half a cycle, which has not ended
    CHECK(walk.speed() == Approx(0.05));
    walk.go(0.5, 1, {1, 0, 0});
    CHECK(walk.speed() == Approx((3 * 0.05 + 1) / 4));
}

TEST_CASE("what sways within a cycle is no way, but every cycle's own is, whichever way it leads", "[unit]") {
    Walk walk;
    walk.go(1, 1, {});
    for (int i = 0; i < 3; ++i) {
        walk.go(0.5, 1, {0, 0, 0.2});
        walk.go(0.5, 1, {0, 0, -0.2});
    }
    CHECK(walk.speed() == Approx(0).margin(1e-12));
    walk.go(1, 1, {0.03, 0, 0});
    walk.go(1, 1, {0, 0, -0.05});  // round a corner
    CHECK(walk.journey.way == Approx(0.08));
}

TEST_CASE("before there are two cycles speed and way are over all there was, at the end of the first too",
          "[unit]") {
    Walk walk;
    CHECK(walk.speed() == 0);
    CHECK(walk.way() == 0);
    walk.go(0.5, 1, {0.02, 0, 0});
    CHECK(walk.speed() == Approx(0.02));
    CHECK(walk.way() == Approx(0.02));
    walk.go(0.5, 1, {0.04, 0, 0});
    CHECK(walk.speed() == Approx(0.03));
    walk.go(0.5, 1, {0.06, 0, 0});
    CHECK(walk.speed() == Approx(0.04));
    CHECK(walk.way() == Approx(0.04));
}

TEST_CASE("the way of a cycle is that of the gait's own cycles, at whatever pace they go", "[unit]") {
    for (const double pace : {0.5, 1., 2., 5., -1.}) {
        CAPTURE(pace);
        Walk walk;
        walk.go(8, pace, {0.04, 0, 0});
        CHECK(walk.speed() == Approx(0.04));
        CHECK(walk.way() == Approx(0.04 / std::abs(pace)));
    }
    Walk still;
    still.go(2, 0, {0.04, 0, 0});  // pushed by somebody
    CHECK(still.speed() == Approx(0.04));
    CHECK(still.way() == 0);
}

TEST_CASE("cycles that go backward count as those that go forward, and a pause lasts as long as it does",
          "[unit]") {
    Walk back;
    back.go(1, -1, {});
    back.go(2, -1, {-0.04, 0, 0});
    CHECK(back.journey.cycle == 3);
    CHECK(back.speed() == Approx(0.04));
    Walk pause;
    pause.go(2, 1, {0.04, 0, 0});
    CHECK(pause.speed() == Approx(0.04));
    pause.go(1, 0, {});
    CHECK(pause.speed() == Approx(0.04));  // as long as its cycle lasts
    pause.go(1, 1, {0.04, 0, 0});
    CHECK(pause.speed() == Approx(0.08 / 3));
}
