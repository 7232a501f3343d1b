#include "study/pareto.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver::study;

TEST_CASE("the front is what no other point beats in both cost and error", "[unit]") {
    const std::vector<CostError> points = {{1, 1e-2},   {2, 1e-3}, {3, 1e-3},       {4, 1e-5},
                                           {2.5, 5e-3}, {4, 1e-6}, {0.5, HUGE_VAL}, {9, std::nan("")}};
    CHECK(pareto_front(points) == std::vector<std::size_t>{0, 1, 5});
    CHECK(pareto_front({}).empty());
}

TEST_CASE("the cheapest point within a bound is found, the bound included", "[unit]") {
    const std::vector<CostError> points = {{1, 1e-2}, {3, 1e-4}, {2, 1e-4}, {5, 0}};
    CHECK(cheapest_within(points, 1e-2) == 0u);
    CHECK(cheapest_within(points, 1e-4) == 2u);
    CHECK(cheapest_within(points, 1e-5) == 3u);
    CHECK(cheapest_within(points, -1.0) == std::nullopt);
}

TEST_CASE("decades go from the one that holds the largest error to the one that holds the least", "[unit]") {
    CHECK(decades(std::vector<CostError>{{1, 3e-3}, {1, 1e-5}, {1, 0}, {1, HUGE_VAL}}) ==
          std::vector<int>{-2, -3, -4, -5});
    CHECK(decades(std::vector<CostError>{{1, 0}}).empty());
}
