#include "neighbors.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;

TEST_CASE("everybody sees all others within the reach, and no one else", "[unit]") {
    constexpr double kReach = 0.13;
    const RandomStream random(5, "crowd");
    std::vector<Vec3> crowd(500);
    for (std::size_t i = 0; i < crowd.size(); ++i)
        crowd[i] = {random.uniform(3 * i, -1, 1), random.uniform(3 * i + 1, -0.2, 0.2),
                    random.uniform(3 * i + 2, -1, 1)};
    Neighbors neighbors;
    neighbors.gather(crowd, kReach);
    std::vector<Vec3> near(crowd.size());
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < crowd.size(); ++i) {
        const std::size_t count = neighbors.around(i, near);
        std::size_t expected = 0;
        for (std::size_t j = 0; j < crowd.size(); ++j) {
            if (j == i || distance(crowd[i], crowd[j]) >= kReach) continue;
            ++expected;
            CHECK(std::count(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), crowd[j]) == 1);
        }
        CHECK(count == expected);
        pairs += count;
    }
    CHECK(pairs > 500);
}

TEST_CASE("where not all fit the nearest are told, on whichever side they are", "[unit]") {
    std::vector<Vec3> grid;
    for (int x = -6; x <= 6; ++x)
        for (int z = -6; z <= 6; ++z) grid.push_back({0.01 * x, 0, 0.01 * z});
    Neighbors neighbors;
    neighbors.gather(grid, 0.1);
    std::vector<Vec3> near(20);  // as many as are within 2 sqrt(2) steps, but for the four at 2.24 and more
    const std::size_t middle = grid.size() / 2;
    REQUIRE(neighbors.around(middle, near) == near.size());
    Vec3 sum;
    for (const Vec3& each : near) {
        CHECK(norm(each) < 0.0224);
        sum += each;
    }
    CHECK(norm(sum) < 1e-15);
}

TEST_CASE("no more are told than there is room for, and who is nowhere is nobody's neighbor", "[unit]") {
    constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> crowd{{0, 0, 0}, {0.1, 0, 0}, {kNowhere, 0, 0}, {0, 0.1, 0}, {1e300, 0, 0}};
    Neighbors neighbors;
    neighbors.gather(crowd, 1);
    std::vector<Vec3> near(8);
    CHECK(neighbors.around(0, near) == 2);
    CHECK(neighbors.around(2, near) == 0);
    CHECK(neighbors.around(4, near) == 0);
    CHECK(neighbors.around(0, std::span(near).first(1)) == 1);
    neighbors.gather({}, 1);
}
