#include "construction.hpp"

#include <catch2/catch.hpp>

#include "mass_spring/network.hpp"
#include "orbweaver/fault.hpp"
#include "prestress.hpp"
#include "sample_webs.hpp"
#include "sanitized.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

/// Anchors around the origin at uneven angles and distances, then tilted and lifted off their plane.
std::vector<Vec3> random_anchors(std::uint64_t seed) {
    const RandomStream random(seed, "anchors");
    const auto count = static_cast<std::size_t>(random.uniform(0, 3, 51));
    const double spread = random.uniform(1, 0, 0.95);
    const double extent = random.uniform(2, 0.05, 1.5);
    const double tilt = random.uniform(3, -90, 90);
    std::vector<Vec3> anchors;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 360 * (static_cast<double>(i) + spread * random.uniform(10 + 3 * i, -0.5, 0.5)) /
                             static_cast<double>(count);
        const double r = extent * (1 - spread * random.uniform(11 + 3 * i) * 0.7);
        const double x = r * cos_degrees(angle);
        const double off = 0.1 * extent * random.uniform(12 + 3 * i, -1, 1);
        anchors.push_back({x * cos_degrees(tilt) - off * sin_degrees(tilt), r * sin_degrees(angle),
                           x * sin_degrees(tilt) + off * cos_degrees(tilt)});
    }
    return anchors;
}

void check_sound(const Layout& layout, const mass_spring::Network& network) {
    const auto faults = mass_spring::validate(network, layout.positions);
    CHECK(faults.empty());
    if (!faults.empty()) UNSCOPED_INFO(faults.front().sentence);
    CHECK(mass_spring::count_parts(network) == 1);
}

}  // namespace

TEST_CASE("the same seed lays the same web and another seed another", "[unit]") {
    const Layout first = web::test::thesis_layout(0.3, 1);
    CHECK(first.positions == web::test::thesis_layout(0.3, 1).positions);
    CHECK(first.positions != web::test::thesis_layout(0.3, 2).positions);
}

TEST_CASE("any anchors in general position give one sound web", "[extreme]") {
    constexpr auto kWebs = static_cast<std::uint64_t>(repetitions(90));
    std::size_t laid = 0;
    for (std::uint64_t seed = 0; seed < kWebs; ++seed) {
        INFO("seed " << seed);
        Diagnostics faults;
        const auto site = survey(random_anchors(seed), std::nullopt, faults);
        CHECK(site.has_value() == faults.empty());
        if (!site) {  // an anchor hidden behind another's frame thread: refused in words
            CHECK_THAT(faults.front().what, Catch::Contains("does not see the frame thread"));
            continue;
        }
        ++laid;
        Construction how;
        how.irregularity = 0.4;
        Layout layout = construct(*site, how, RandomStream(seed, "web"));
        check_sound(layout, over_extend(layout, how, web::test::kMass, 0));
        const auto network =
            find_form(layout, web::test::default_silks(), web::test::kMass, 0, web::test::kGravity);
        check_sound(layout, network);
    }
    CHECK(3 * laid > 2 * kWebs);
}
