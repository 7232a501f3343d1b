#include "naturalness.hpp"

#include <catch2/catch.hpp>

#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// The difference at every value of either sample, each counted anew.
double distance_by_definition(const std::vector<double>& one, const std::vector<double>& other) {
    const auto share_up_to = [](const std::vector<double>& sample, double value) {
        return static_cast<double>(
                   std::count_if(sample.begin(), sample.end(), [&](double each) { return each <= value; })) /
               static_cast<double>(sample.size());
    };
    double farthest = 0;
    for (const auto* sample : {&one, &other})
        for (const double value : *sample)
            farthest = std::max(farthest, std::abs(share_up_to(one, value) - share_up_to(other, value)));
    return farthest;
}

std::vector<double> random_sample(std::uint64_t seed, double from) {
    const RandomStream random(seed, "sample");
    std::vector<double> sample(1 + random.bits(0) % 30);
    for (std::size_t i = 0; i < sample.size(); ++i)
        sample[i] = from + std::floor(random.uniform(i + 1, 0, 12));  // ties within and between samples
    std::sort(sample.begin(), sample.end());
    return sample;
}

/// Two radii from a shared point of the hub, upright and to the right, with rings at those distances (m).
test::HandMade two_radii(std::initializer_list<double> upright, std::initializer_list<double> level) {
    test::HandMade web;
    web.points = {{0, 0, 0}, {0, -0.01, 0}};
    web.join(0, 1, test::kHub);
    std::vector<std::uint32_t> turns[2];
    for (const int way : {0, 1}) {
        std::uint32_t last = 0;
        for (const double at : way == 0 ? upright : level) {
            const auto next = static_cast<std::uint32_t>(web.points.size());
            web.points.push_back(way == 0 ? Vec3{0, at, 0} : Vec3{at, 0, 0});
            web.join(last, next, test::kRadius);
            turns[way].push_back(last = next);
        }
    }
    // Every point but the last of each radius, which is on the frame.
    for (std::size_t i = 0; i + 1 < turns[0].size(); ++i) web.join(turns[0][i], turns[1][i], test::kSpiral);
    web.join(turns[0].back(), turns[1].back(), test::kFrame);
    return web;
}

void check_values(const std::vector<double>& found, const std::vector<double>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-12));
}

}  // namespace

TEST_CASE("Kolmogorov's distance is that of its definition", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const auto one = random_sample(2 * seed, 0), other = random_sample(2 * seed + 1, seed % 5);
        const double expected = distance_by_definition(one, other);
        CHECK(kolmogorov_distance(one, other) == Approx(expected).margin(1e-15));
        CHECK(kolmogorov_distance(other, one) == Approx(expected).margin(1e-15));
    }
}

TEST_CASE("samples that share nothing are at distance 1, the same ones at 0", "[unit]") {
    const std::vector<double> low = {1, 2, 3}, high = {4, 5}, none;
    CHECK(kolmogorov_distance(low, high) == 1);
    CHECK(kolmogorov_distance(low, low) == 0);
    CHECK(kolmogorov_distance(low, none) == 1);
    CHECK(kolmogorov_distance(none, none) == 0);
}

TEST_CASE("spacings are those of each radius, also where two begin at one point of the hub", "[unit]") {
    check_values(spacings(two_radii({0.03, 0.05, 0.09, 0.2}, {0.035, 0.045, 0.1, 0.2})),
                 {0.01, 0.02, 0.04, 0.055});
}

TEST_CASE("an orb's spacings are its mesh, and twice that where a turn is taken", "[unit]") {
    const test::HandMade orb = test::make_orb(12, 5);
    const auto plain = spacings(orb);
    CHECK(plain.size() == 12 * 4);
    CHECK(plain.front() == Approx(orb.mesh).epsilon(1e-9));
    CHECK(plain.back() == Approx(orb.mesh).epsilon(1e-9));
    WebChange change;  // the third turn
    for (std::uint32_t i = 0; i < orb.segments.size(); ++i) {
        const double from_hub = distance(orb.points[orb.segments[i].a], orb.center) / orb.mesh;
        if (orb.segments[i].kind == test::kSpiral && std::lround(from_hub) == test::kHubMeshes + 3)
            change.removed.push_back(i);
    }
    REQUIRE(change.removed.size() == 12);
    const test::HandMade after = test::changed(orb, change);
    const auto found = spacings(after);
    CHECK(found.size() == 12 * 3);
    CHECK(std::count_if(found.begin(), found.end(), [&](double each) { return each > 1.5 * orb.mesh; }) == 12);
}

TEST_CASE("what is taken of the spiral shows in the distance of spacings", "[unit]") {
    // Lengths without rounding: turns at 1 m from each other, of which the third is taken.
    const test::HandMade web = two_radii({1, 2, 3, 4, 9}, {1, 2, 3, 4, 9});
    const auto third = static_cast<std::uint32_t>(1 + 2 * 5 + 2);
    REQUIRE(web.segments[third].kind == test::kSpiral);
    const WebChange change{{third}, {}, {}};
    CHECK(compare(web, change, test::changed(web, change)).spacing_distance ==
          0.5);  // 1 and 2 instead of 1, 1, 1
}

TEST_CASE("silk is counted by its lengths and widths, against that of the plain web", "[unit]") {
    test::HandMade web = two_radii({0.03, 0.04, 0.1}, {0.04, 0.03, 0.1});
    web.segments[7].width = 2;  // the first spiral thread, 5 cm; the second is as long
    REQUIRE(web.segments[7].kind == test::kSpiral);
    const double all = 0.01 + (0.1 + 0.12) + 3 * 0.05 + std::hypot(0.1, 0.1);
    SECTION("taken") {
        const WebChange change{{7}, {}, {}};
        const Naturalness found = compare(web, change, test::changed(web, change));
        CHECK(found.silk_removed == Approx(0.1));
        CHECK(found.silk_added == 0);
        CHECK(found.silk_share == Approx(0.1 / all));
    }
    SECTION("added, of the sort of another") {
        const WebChange change{{}, {{3, 5, 7, 1.5}}, {}};
        const Naturalness found = compare(web, change, test::changed(web, change));
        CHECK(found.silk_removed == 0);
        CHECK(found.silk_added == Approx(1.5 * 2 * distance(web.points[3], web.points[5])));
    }
    SECTION("thickened and thinned") {
        const WebChange change{{}, {}, {{7, 0, 0.25, 3}, {7, 0.5, 1, 0.5}, {8, 0.2, 0.4, 5}}};
        const Naturalness found = compare(web, change, test::changed(web, change));
        CHECK(found.silk_added == Approx(2 * 0.25 * 0.1 + 4 * 0.2 * 0.05));
        CHECK(found.silk_removed == Approx(0.5 * 0.5 * 0.1));
        CHECK(found.silk_share == Approx((0.05 + 0.04 + 0.025) / all));
    }
    SECTION("left alone") {
        const Naturalness found = compare(web, {}, web);
        CHECK(found.silk_share == 0);
        CHECK(found.max_tension_ratio == 1);
        CHECK(found.tension_change == 0);
        CHECK(found.mean_shift == 0);
        CHECK(found.new_slack == 0);
        CHECK(found.spacing_distance == 0);
    }
}

TEST_CASE("tensions are compared of threads that stay whole, shifts of the plain web's points", "[unit]") {
    test::HandMade plain = test::make_orb(8, 3);
    plain.tension[5] = -0.25;                // slack before and after
    const std::uint32_t spiral = 8 * 4 + 8;  // behind radii and hub
    REQUIRE(plain.segments[spiral].kind == test::kSpiral);
    const WebChange change{{spiral}, {{0, 11, spiral, 1}}, {{spiral + 1, 0.25, 0.75, 4}}};
    test::HandMade after = test::changed(plain, change);
    REQUIRE(after.segments.size() == plain.segments.size() + 2);
    after.tension[spiral] = 9;        // the first part of what was cut
    after.tension[spiral + 3] = 0.5;  // behind it, whole
    after.tension[3] = 1.75;          // a radius
    after.tension[5] = -0.25;
    after.tension[7] = -1e-3;                      // slack now
    after.tension[after.tension.size() - 1] = -2;  // what is new may be slack as well
    for (Vec3& point : after.points) point.x += 0.002;
    after.points.back().x += 5;  // no point of the plain web
    const Naturalness found = compare(plain, change, after);
    CHECK(found.max_tension_ratio == 9);
    CHECK(found.tension_change == Approx(1.001));
    CHECK(found.new_slack == 2);
    CHECK(found.mean_shift == Approx(0.002));
}
