#include "plane.hpp"

#include <catch2/catch.hpp>

#include "sample_webs.hpp"

using namespace orbweaver;
using namespace orbweaver::web;

TEST_CASE("a web in the xy plane gets the axes of the scene", "[unit]") {
    const PlaneFit fit = fit_plane(web::test::circle(7, 0.2));
    CHECK(norm(fit.plane.across - Vec3{1, 0, 0}) < 1e-12);
    CHECK(norm(fit.plane.up - Vec3{0, 1, 0}) < 1e-12);
    CHECK(norm(fit.plane.normal - Vec3{0, 0, 1}) < 1e-12);
    CHECK(fit.length == Approx(0.2 / std::sqrt(2.0)));
    CHECK(fit.width == Approx(0.2 / std::sqrt(2.0)));
}

TEST_CASE("a fitted plane contains its points and is upright", "[unit]") {
    const Vec3 across = Vec3{3, 0, 4} / 5;
    const Vec3 along{0, 1, 0};
    std::vector<Vec3> points;
    for (const Vec3& p : web::test::circle(9, 0.3))
        points.push_back(Vec3{1, 2, 3} + across * p.x + along * p.y);
    const Plane plane = fit_plane(points).plane;
    for (const Vec3& p : points) {
        CHECK(std::abs(dot(p - plane.origin, plane.normal)) < 1e-12);
        CHECK(distance(plane.lift(plane.project(p)), p) < 1e-12);
    }
    CHECK(plane.up.y == Approx(1));
    CHECK(norm(cross(plane.across, plane.up) - plane.normal) < 1e-12);
}

TEST_CASE("a web that lies flat has an up all the same", "[unit]") {
    const Plane plane = upright_plane({}, {0, 1, 0});
    CHECK(norm(plane.up - Vec3{0, 0, -1}) < 1e-12);
    CHECK(norm(cross(plane.across, plane.up) - plane.normal) < 1e-12);
}

TEST_CASE("points on a line have no width", "[unit]") {
    CHECK(fit_plane(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}}).width < 1e-7);
}
