#include "leg_ways.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

using Effort = ReachWays::Effort;
using Reach = ReachWays::Reach;

std::vector<Reach> reaches(LegWays& ways, std::size_t way, std::size_t kind, const Effort& effort) {
    std::vector<Reach> found(ways.count(kind));
    ways.reach(way, kind, effort, found);
    return found;
}

double worst(const std::vector<Reach>& all) {
    return std::max_element(all.begin(), all.end(),
                            [](const Reach& a, const Reach& b) { return a.error < b.error; })
        ->error;
}

}  // namespace

TEST_CASE("every solver is a way, and so are the lanes", "[unit]") {
    const Species huntsman = test::creature("huntsman");
    const LegWays ways(huntsman);
    REQUIRE(ways.ways().size() == leg_solvers().size() + 1);
    for (std::size_t i = 0; i < leg_solvers().size(); ++i) CHECK(ways.ways()[i].name == leg_solvers()[i].name);
    CHECK(ways.limbs() == 8);
    CHECK(ways.count(0) == 8 * FootPaths::kTimes);
}

TEST_CASE("warm targets are reached by every way within its tolerance, and said to be", "[unit]") {
    const Species ant = test::creature("ant");
    LegWays ways(ant);
    for (std::size_t way = 0; way < ways.ways().size(); ++way)
        for (const double tolerance : {1e-2, 1e-6}) {
            CAPTURE(ways.ways()[way].name, tolerance);
            const auto found = reaches(ways, way, 0, {tolerance, 0});
            CHECK(worst(found) <= tolerance * (1 + 1e-9));
            CHECK(std::all_of(found.begin(), found.end(), [](const Reach& each) { return each.claimed; }));
        }
}

// The lanes give the bits of the solver: so do their errors.
TEST_CASE("the lanes err as the half Jacobian does, target by target", "[unit]") {
    const Species lizard = test::creature("lizard");
    LegWays ways(lizard);
    for (std::size_t kind = 0; kind < ways.kinds().size(); ++kind)
        for (const Effort& effort : {Effort{1e-4, 0}, Effort{0, 2}}) {
            const auto one = reaches(ways, 0, kind, effort), lanes = reaches(ways, 4, kind, effort);
            for (std::size_t i = 0; i < one.size(); ++i) REQUIRE(one[i].error == lanes[i].error);
        }
}

TEST_CASE("more steps of one search come nearer to cold targets", "[unit]") {
    const Species huntsman = test::creature("huntsman");
    LegWays ways(huntsman);
    const auto cold = ways.kinds().size() - 1;
    const auto median = [&](int steps) {
        auto found = reaches(ways, 0, cold, {0, steps});
        std::nth_element(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2),
                         found.end(), [](const Reach& a, const Reach& b) { return a.error < b.error; });
        return found[found.size() / 2].error;
    };
    CHECK(median(1) > 1e-2);
    CHECK(median(3) < 0.1 * median(1));
    CHECK(median(13) < 1e-12);
    CHECK(worst(reaches(ways, 0, cold, {1e-6, 0})) <= 1e-6 * (1 + 1e-9));
}
