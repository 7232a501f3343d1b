#include "thread_kinds.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

TEST_CASE("threads of a kind are found in the web's order, each of one kind alone", "[unit]") {
    const test::HandMade web = test::random_web(10, 100, 1);
    std::vector<std::uint32_t> all;
    for (std::uint32_t kind = 0; kind < test::kKinds.size(); ++kind) {
        const auto found = threads_of(web, test::kKinds[kind]);
        CHECK(std::is_sorted(found.begin(), found.end()));
        for (const std::uint32_t i : found) CHECK(web.segments[i].kind == kind);
        all.insert(all.end(), found.begin(), found.end());
    }
    std::sort(all.begin(), all.end());
    std::vector<std::uint32_t> each(100);
    std::iota(each.begin(), each.end(), 0U);
    CHECK(all == each);
}

TEST_CASE("kinds that a web lacks, or that nobody knows, have no threads", "[unit]") {
    const test::HandMade orb = test::make_orb(8, 3);
    CHECK(threads_of(orb, "spiral").size() == 8 * 3);
    CHECK(threads_of(orb, "radius").size() == 8 * 4);
    CHECK(threads_of(orb, "strand").empty());
    CHECK(threads_of(orb, "Spiral").empty());
    CHECK(threads_of(orb, "").empty());
}

TEST_CASE("points of a radius lead outward to its end, whichever way its threads were laid", "[unit]") {
    test::HandMade orb = test::make_orb(5, 3);  // five points a radius
    for (std::size_t i = 0; i < orb.segments.size(); i += 3) std::swap(orb.segments[i].a, orb.segments[i].b);
    orb.points.push_back(orb.center);
    orb.join(25, 1, test::kSpiral);  // on no radius
    const auto next = next_outward(orb);
    REQUIRE(next.size() == 26);
    for (std::uint32_t i = 0; i < 25; ++i) CHECK(next[i] == (i % 5 == 4 ? i : i + 1));
    CHECK(next[25] == 25);
}
