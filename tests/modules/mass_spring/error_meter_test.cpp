#include "error_meter.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using orbweaver::Vec3;
using orbweaver::mass_spring::ErrorMeter;

TEST_CASE("a sample is Richardson's estimate and stands for the frames before it", "[unit]") {
    ErrorMeter meter;
    CHECK(std::isnan(meter.estimate()));
    const std::vector<Vec3> whole{{0, 0, 0}, {1, 0, 0}};
    const std::vector<Vec3> halved{{0, 0, 0}, {1, 3e-6, 4e-6}};
    for (int i = 0; i < 10; ++i) meter.count_frame();
    meter.add(whole, halved, 1);  // 5e-6 * 2/(2 - 1), for ten frames
    CHECK(meter.estimate() == Approx(1e-4).epsilon(1e-12));
    for (int i = 0; i < 5; ++i) meter.count_frame();
    CHECK(meter.estimate() == Approx(1.5e-4).epsilon(1e-12));
    CHECK(meter.how() ==
          "step doubling: largest change of a position when a frame is redone in steps half as long, 1 of 15 "
          "frames "
          "redone, what is left a frame later of errors of single frames added up");
}

TEST_CASE("errors that are damped within a frame count once, what is left of them as often as there are frames",
          "[unit]") {
    ErrorMeter meter;
    const std::vector<Vec3> whole{{1, 0, 0}}, halved{{1, 5e-6, 0}}, left{{1, 1e-6, 0}};
    meter.count_frame();
    meter.add(whole, halved, 1);
    CHECK(meter.estimate() == Approx(1e-5).epsilon(1e-9));
    meter.follow(whole, left, 1);
    for (int i = 0; i < 9; ++i) meter.count_frame();
    CHECK(meter.estimate() == Approx(10 * 2e-6 + 8e-6).epsilon(1e-9));
    meter.add(whole, whole, 1);  // no error in the frames that it stands for
    CHECK(meter.estimate() == Approx(2e-6 + 8e-6).epsilon(1e-9));
}

TEST_CASE("an error that grows a frame later counts as grown", "[unit]") {
    ErrorMeter meter;
    const std::vector<Vec3> whole{{1, 0, 0}}, halved{{1, 5e-6, 0}}, left{{1, 10e-6, 0}};
    meter.count_frame();
    meter.add(whole, halved, 1);
    meter.follow(whole, left, 1);
    CHECK(meter.estimate() == Approx(2e-5).epsilon(1e-9));
}

TEST_CASE("frames are sampled at powers of two, then every 64", "[unit]") {
    ErrorMeter meter;
    const std::vector<Vec3> whole{{1, 0, 0}};
    std::vector<std::uint64_t> sampled;
    for (std::uint64_t i = 0; i < 200; ++i) {
        meter.count_frame();
        if (!meter.wants(i)) continue;
        meter.add(whole, whole, 1);
        sampled.push_back(i);
    }
    CHECK(sampled == std::vector<std::uint64_t>{0, 1, 2, 4, 8, 16, 32, 64, 128, 192});
}

TEST_CASE("a run that was restored samples its first frame, whatever its number", "[unit]") {
    ErrorMeter meter;
    CHECK(meter.wants(67));
    meter.count_frame();
    meter.add(std::vector<Vec3>{{1, 0, 0}}, std::vector<Vec3>{{1, 1e-6, 0}}, 1);
    CHECK_FALSE(meter.wants(68));
}

TEST_CASE("a judge tells errors of position, and of velocity as a way, and what cannot be redone is not known",
          "[unit]") {
    ErrorMeter meter("tr_bdf2");
    const std::vector<Vec3> x{{1, 0, 0}}, judged_x{{1, 3e-6, 4e-6}}, v{{0, 0, 1}}, judged_v{{0, 0, 1.01}};
    for (int i = 0; i < 2; ++i) meter.count_frame();
    meter.add_judged(x, judged_x, v, judged_v, 1e-3);
    CHECK(meter.estimate() == Approx(2 * (5e-6 + 1e-5)).epsilon(1e-9));
    CHECK(meter.how() ==
          "another method: largest change of a position, and of a velocity as a frame's way, when a frame is "
          "redone by tr_bdf2, 1 of 2 frames redone, errors of single frames added up");
    meter.count_frame();
    meter.add_unknown();
    CHECK(std::isinf(meter.estimate()));
    CHECK(meter.how().find("1 of them could not be redone: the error is not known") != std::string::npos);
}
