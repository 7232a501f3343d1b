#include "layout.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

namespace {

std::vector<Index> lay(Layout& layout, double length, double placement, double amount, std::size_t least = 1) {
    const Index from = add_particle(layout, {0, 0, 0}, true);
    const Index to = add_particle(layout, {length, 0, 0}, true);
    Jitter jitter(RandomStream(3, "jitter"), amount);
    return lay_strand(layout, from, to, Kind::radius, placement, least, jitter);
}

}  // namespace

TEST_CASE("a strand's masses divide its length as evenly as the placement allows", "[unit]") {
    Layout layout;
    const auto strand = lay(layout, 0.1, 0.007, 0);
    REQUIRE(strand.size() == 15);  // 0.1/0.007 = 14.3 pieces
    for (std::size_t i = 0; i < strand.size(); ++i)
        CHECK(layout.positions[strand[i]].x == Approx(0.1 * static_cast<double>(i) / 14));
    CHECK(layout.pieces.size() == 14);
    CHECK(layout.fixed == std::vector<std::uint8_t>{1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("a strand shorter than its placement still has the pieces asked for", "[unit]") {
    Layout layout;
    CHECK(lay(layout, 0.001, 0.02, 0, 2).size() == 3);
}

TEST_CASE("jitter keeps the order of masses and the same stream gives the same strand", "[unit]") {
    Layout layout, again;
    const auto strand = lay(layout, 1, 0.01, 0.9);
    lay(again, 1, 0.01, 0.9);
    CHECK(layout.positions == again.positions);
    for (std::size_t i = 1; i < strand.size(); ++i)
        CHECK(layout.positions[strand[i]].x - layout.positions[strand[i - 1]].x > 0.0009);
}

TEST_CASE("a layout refuses to outgrow its limit before it takes the memory", "[extreme]") {
    Layout layout;
    CHECK_THROWS_WITH(lay(layout, 1e4, 1e-9, 0),
                      Catch::StartsWith("the web would have more than 500000 particles"));
    CHECK(layout.positions.size() == 2);
    CHECK_THROWS_AS(lay(layout, 1e4, 1e-300, 0), Fault);
}
