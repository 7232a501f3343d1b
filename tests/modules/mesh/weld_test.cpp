#include "weld.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

TEST_CASE("points of equal coordinates are one, and no others", "[unit]") {
    const double next = std::nextafter(1.0, 2.0);
    const std::vector<Vec3> points = {{1, 0, 0}, {next, 0, 0}, {1, -0.0, 0}, {1, 0, 0}, {next, 0, 0}};
    CHECK(weld(points) == std::vector<std::uint32_t>{0, 1, 0, 0, 1});
}

TEST_CASE("within a tolerance a point joins the first that kept its place", "[unit]") {
    const std::vector<Vec3> points = {{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {2.5, 0, 0}, {-0.5, -0.5, -0.5}};
    CHECK(weld(points, 1) == std::vector<std::uint32_t>{0, 0, 2, 2, 0});
}

TEST_CASE("welding within a tolerance agrees with a search of all pairs", "[unit]") {
    const RandomStream random(3, "weld");
    std::vector<Vec3> points;
    for (std::uint64_t i = 0; i < 600; ++i)
        points.push_back(
            {random.uniform(3 * i, -1, 1), random.uniform(3 * i + 1, -1, 1), random.uniform(3 * i + 2, -1, 1)});
    std::vector<std::uint32_t> expected(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        expected[i] = i;
        for (std::uint32_t j = 0; j < i && expected[i] == i; ++j)
            if (expected[j] == j && distance(points[i], points[j]) <= 0.2) expected[i] = j;
    }
    CHECK(weld(points, 0.2) == expected);
}
