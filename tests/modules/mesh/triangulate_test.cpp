#include "triangulate.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "orbweaver/exact_math.hpp"
#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

std::vector<Triangle> cut(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> polygon(points.size());
    std::iota(polygon.begin(), polygon.end(), 0);
    std::vector<Triangle> triangles;
    triangulate(points, polygon, triangles);
    return triangles;
}

/// Twice the area, counted positive counter-clockwise about z.
double area(const std::vector<Vec3>& points, const Triangle& t) {
    return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]).z;
}

double shoelace(const std::vector<Vec3>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += cross(points[i], points[(i + 1) % points.size()]).z;
    return sum;
}

/// A comb of teeth: every other corner of its back edge is reflex.
std::vector<Vec3> comb(std::size_t teeth) {
    std::vector<Vec3> points = {{static_cast<double>(teeth), -1, 0}};
    for (std::size_t i = teeth; i > 0; --i) {
        points.push_back({static_cast<double>(i), 1, 0});
        points.push_back({static_cast<double>(i) - 0.5, 0, 0});
    }
    points.push_back({0, 1, 0});
    points.push_back({0, -1, 0});
    return points;
}

}  // namespace

// Pieces that are all wound as the whole, and whose areas add up to its own, cover it once.
TEST_CASE("a polygon's pieces are wound as it is and cover it once", "[unit]") {
    const std::vector<std::pair<const char*, std::vector<Vec3>>> polygons = {
        {"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
        {"square", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
        {"dart, reflex at the second corner", {{0, 0, 0}, {1, 0.9, 0}, {2, 0, 0}, {1, 3, 0}}},
        {"dart, reflex at the last corner", {{1, 3, 0}, {0, 0, 0}, {1, 0.9, 0}, {2, 0, 0}}},
        {"square with a corner in the middle of its first side",
         {{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
        {"L", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}}},
        {"comb", comb(40)}};
    for (const auto& [name, points] : polygons) {
        INFO(name);
        const auto triangles = cut(points);
        CHECK(triangles.size() == points.size() - 2);
        double sum = 0;
        double least = 1;
        for (const Triangle& t : triangles) {
            sum += area(points, t);
            least = std::min(least, area(points, t));
        }
        CHECK(least > 0);
        CHECK(sum == Approx(shoelace(points)).epsilon(1e-13));  // sums of few hundred rounded products
    }
}

TEST_CASE("a polygon is cut alike whichever plane it lies in", "[unit]") {
    const auto flat = comb(5);
    std::vector<Vec3> turned;
    for (const Vec3& p : flat) turned.push_back(Vec3{p.z, p.x, p.y} * 0.125);
    CHECK(cut(turned) == cut(flat));
}

TEST_CASE("a polygon that crosses itself still becomes two triangles less than it has corners", "[unit]") {
    std::vector<Vec3> star;
    for (int i = 0; i < 5; ++i) star.push_back({cos_degrees(144.0 * i), sin_degrees(144.0 * i), 0});
    CHECK(cut(star).size() == 3);
    CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
    CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).size() == 2);
}

TEST_CASE("a polygon that would take too long to cut is refused, a convex one of any size is not", "[unit]") {
    CHECK_THROWS_WITH(cut(comb(3000)),
                      "a polygon of 6003 corners is not convex; expected at most 4096 corners, so split it");
    std::vector<Vec3> disk;
    for (int i = 0; i < 50'000; ++i)
        disk.push_back({cos_degrees(i * 360.0 / 50'000), sin_degrees(i * 360.0 / 50'000), 0});
    CHECK(cut(disk).size() == 49'998);
}
