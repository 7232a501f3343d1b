#include "gait.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace orbweaver::spider;

namespace {

constexpr double kFrame = 1.0 / 60;  // s

/// A creature that only steps.
struct Walker {
    explicit Walker(std::size_t legs, const Gait& gait)
        : start(legs), progress(legs), strained(legs), lifted(legs), landed(legs) {
        begin_gait(gait, state());
    }
    GaitState state() { return {&phase, start, progress}; }
    void advance(const Gait& gait, const Pace& pace) {
        advance_gait(gait, pace, {kFrame, 0.2, 0.5, strained, lifted, landed, feet, velocity, {}}, state());
    }
    int feet_down() const {
        int down = 0;
        for (const double each : progress) down += each < 0 ? 1 : 0;
        return down;
    }

    double phase = 0;
    std::vector<double> start, progress;
    std::vector<std::uint8_t> strained, lifted, landed;
    std::vector<SupportPoint> feet;  // none: balance is not looked at
    SupportPoint velocity;
};

struct Counts {
    double mean_down = 0;
    int least_down = 100;
    std::vector<int> lifts;
    std::vector<double> duty;
};

Counts walk(const char* name, std::size_t legs, const Pace& pace, int frames) {
    const Gait& gait = *find_gait(name);
    Walker walker(legs, gait);
    for (int i = 0; i < 240; ++i) walker.advance(gait, pace);
    Counts counts;
    counts.lifts.resize(legs);
    counts.duty.resize(legs);
    for (int i = 0; i < frames; ++i) {
        walker.advance(gait, pace);
        counts.mean_down += walker.feet_down() / static_cast<double>(frames);
        counts.least_down = std::min(counts.least_down, walker.feet_down());
        for (std::size_t leg = 0; leg < legs; ++leg) {
            counts.lifts[leg] += walker.lifted[leg];
            counts.duty[leg] += (walker.progress[leg] < 0 ? 1.0 : 0.0) / frames;
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("a tetrapod at a tarantula's duty factor has 5.44 feet down, and never less than four", "[unit]") {
    constexpr int kFrames = 60000;
    const Counts counts = walk("tetrapod", 8, {0.05, 1.7, 0.68}, kFrames);
    CHECK(counts.mean_down == Approx(8 * 0.68).epsilon(0.002));
    CHECK(counts.least_down >= 4);
    for (std::size_t leg = 0; leg < 8; ++leg) {
        CHECK(counts.lifts[leg] == Approx(1.7 * kFrames * kFrame).margin(1));
        CHECK(counts.duty[leg] == Approx(0.68).epsilon(0.003));
    }
}

TEST_CASE("each gait keeps the feet down that its duty factor says", "[unit]") {
    CHECK(walk("ripple", 8, {0.05, 1.3, 0.75}, 60000).mean_down == Approx(6).epsilon(0.002));
    const Counts wave = walk("wave", 8, {0.05, 0.9, 0.875}, 60000);
    CHECK(wave.mean_down == Approx(7).epsilon(0.002));
    CHECK(wave.least_down >= 6);  // one lands within the frame in which the next lifts
    const Counts tripod = walk("tetrapod", 6, {0.05, 2, 0.68}, 60000);
    CHECK(tripod.least_down >= 3);
}

TEST_CASE("opposite legs of a tetrapod step half a cycle apart, and sets from back to front", "[unit]") {
    const Gait& gait = *find_gait("tetrapod");
    for (std::size_t leg = 0; leg < 8; leg += 2) {
        const double apart = std::abs(start_of(gait, leg, 8) - start_of(gait, leg + 1, 8));
        CHECK(apart == Approx(0.5));
    }
    CHECK(start_of(gait, 6, 8) == 0);                    // R4
    CHECK(start_of(gait, 5, 8) > start_of(gait, 6, 8));  // L3 follows R4
    CHECK(start_of(gait, 2, 8) > start_of(gait, 5, 8));  // R2 follows L3
    CHECK(start_of(gait, 1, 8) > start_of(gait, 2, 8));  // L1 follows R2
}

TEST_CASE("gaits and paces blend without a jump", "[unit]") {
    Walker walker(8, *find_gait("tetrapod"));
    double fastest = 0, allowed = 0;  // of a swing in a frame
    std::vector<double> before;
    for (int i = 0; i < 2400; ++i) {
        const Gait& gait = *find_gait(i / 400 % 3 == 0 ? "tetrapod" : i / 400 % 3 == 1 ? "wave" : "ripple");
        const PaceRange range{0.3, 0.02, 0.06, 0.8, 0.6};
        const double speed = 0.15 * (1 + std::sin(i * 0.01));
        before = walker.progress;
        const Pace pace = pace_at(range, speed);
        allowed = std::max(allowed, pace.frequency / (1 - pace.duty) * kFrame);
        walker.advance(gait, pace);
        for (std::size_t leg = 0; leg < 8; ++leg)
            if (before[leg] >= 0 && walker.progress[leg] >= 0) {
                CHECK(walker.progress[leg] > before[leg]);
                fastest = std::max(fastest, walker.progress[leg] - before[leg]);
            }
    }
    CHECK(fastest <= allowed * (1 + 1e-12));
}

TEST_CASE("who stops puts its feet down and leaves them there", "[unit]") {
    const Gait& gait = *find_gait("tetrapod");
    Walker walker(8, gait);
    for (int i = 0; i < 100; ++i) walker.advance(gait, {0.05, 2, 0.7});
    REQUIRE(walker.feet_down() < 8);
    for (int i = 0; i < 13; ++i) walker.advance(gait, {0.02, 0, 0.8});
    CHECK(walker.feet_down() == 8);
    for (int i = 0; i < 100; ++i) walker.advance(gait, {0.02, 0, 0.8});
    CHECK(walker.feet_down() == 8);
}

TEST_CASE("a strained leg steps out of turn, while its neighbors stand", "[unit]") {
    const Gait& gait = *find_gait("tetrapod");
    Walker walker(8, gait);
    walker.strained = {0, 0, 1, 0, 1, 0, 0, 0};  // R2 and R3 both
    walker.advance(gait, {0.02, 0, 0.8});
    CHECK(walker.lifted[2] == 1);
    CHECK(walker.lifted[4] == 0);  // R2 is in the air
    for (int i = 0; i < 12; ++i) {
        walker.advance(gait, {0.02, 0, 0.8});
        walker.strained[2] = 0;
        CHECK((walker.progress[2] >= 0) != (walker.progress[4] >= 0));
    }
}

TEST_CASE("speed is stride times frequency, and both grow with it", "[unit]") {
    const PaceRange range{0.3, 0.02, 0.06, 0.8, 0.6};
    double stride = 0, frequency = -1;
    for (int i = 0; i <= 30; ++i) {
        const double speed = 0.01 * i;
        const Pace pace = pace_at(range, speed);
        CHECK(pace.stride * pace.frequency == Approx(speed).margin(1e-15));
        CHECK(pace.stride > stride);
        CHECK(pace.frequency > frequency);
        stride = pace.stride;
        frequency = pace.frequency;
    }
    CHECK(pace_at(range, 9).duty == Approx(0.6));
}

TEST_CASE("a leg waits whose lift would let the creature fall over, unless it is strained", "[unit]") {
    constexpr int kCycle = 30;  // frames
    const Gait& gait = *find_gait("tetrapod");
    const auto lifts = [&](bool strained) {
        Walker walker(8, gait);
        // Without R4 all weight is behind the feet.
        walker.feet = {{2, -1}, {2, 1}, {2, -1}, {2, 1}, {1, -1}, {1, 1}, {-2, -1}, {0.5, 1}};
        walker.strained[6] = strained ? 1 : 0;
        int lifted = 0;
        for (int i = 0; i < 2 * kCycle; ++i) {
            walker.advance(gait, {0.05, 2, 0.7});
            lifted += walker.lifted[6];
        }
        return lifted;
    };
    CHECK(lifts(false) == 0);
    CHECK(lifts(true) > 0);
}

TEST_CASE("a leg waits where the creature would fall over before it lands", "[unit]") {
    constexpr int kCycle = 30;  // frames
    const Gait& gait = *find_gait("tetrapod");
    const auto lifts = [&](double speed) {
        Walker walker(8, gait);
        walker.feet = {{2, -1}, {2, 1}, {1, -1}, {1, 1}, {-1, -1}, {-1, 1}, {-2, -1}, {-2, 1}};
        walker.velocity = {speed, 0};
        int lifted = 0;
        for (int i = 0; i < 2 * kCycle; ++i) {
            walker.advance(gait, {0.05, 2, 0.7});
            lifted += walker.lifted[0];
        }
        return lifted;
    };
    CHECK(lifts(0) > 0);
    CHECK(lifts(20) == 0);  // 3 in the 0.15 s of a swing: R1 is one of the last two that it has by then
}
