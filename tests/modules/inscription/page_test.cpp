#include "page.hpp"

#include <catch2/catch.hpp>

#include "orbs.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// In a plane that is turned about two axes; 1.5 m, 600 pixels.
Page tilted_page() {
    const Vec3 right = Vec3{2, 1, -2} / 3, up = Vec3{1, 2, 2} / 3;
    return {{0.4, -2, 7}, right, up, 1.5 / 600, 600};
}

void check_same(const Spot& one, const Spot& other) {
    CHECK(one.x == Approx(other.x).margin(1e-9));
    CHECK(one.y == Approx(other.y).margin(1e-9));
}

}  // namespace

// Coordinates of some 10 m over pixels of 2.5 mm: rounding is 1e-12 pixels.
TEST_CASE("a page's spots are where its corners, its middle and its sides say", "[unit]") {
    const Page page = tilted_page();
    check_same(page.spot(page.middle), {300, 300});
    check_same(page.spot(page.middle - 0.75 * page.right + 0.75 * page.up), {0, 0});
    check_same(page.spot(page.middle + 0.75 * page.right - 0.75 * page.up), {600, 600});
    check_same(page.spot(page.middle + 0.0025 * page.right), {301, 300});
    check_same(page.spot(page.middle - 1.5 * page.up), {300, 900});
}

TEST_CASE("points and spots lead to each other, whatever lies before the plane", "[unit]") {
    const Page page = tilted_page();
    const Vec3 normal = cross(page.right, page.up);
    const RandomStream random(1, "spots");
    for (std::uint64_t i = 0; i < 200; ++i) {
        const Spot spot{random.uniform(3 * i, -300, 900), random.uniform(3 * i + 1, -300, 900)};
        check_same(page.spot(page.point(spot)), spot);
        check_same(page.spot(page.point(spot) + random.uniform(3 * i + 2, -1, 1) * normal), spot);
        CHECK(dot(page.point(spot) - page.middle, normal) == Approx(0).margin(1e-12));
    }
}

TEST_CASE("the page of a web is the smallest square that shows it, the web in its middle", "[unit]") {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        test::HandMade web = test::random_web(30, 10, seed);
        web.right = Vec3{2, 1, -2} / 3;
        web.up = Vec3{1, 2, 2} / 3;
        web.center = {5, 6, 7};
        for (Vec3& point : web.points) {
            const double tall = seed % 2 == 0 ? 3 : 0.3;
            point = web.center + (point.x + 2) * web.right + tall * point.y * web.up;
        }
        const Page page = page_of(web, 200);
        double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
        for (const Vec3& point : web.points) {
            const Spot spot = page.spot(point);
            left = std::min(left, spot.x);
            right = std::max(right, spot.x);
            top = std::min(top, spot.y);
            bottom = std::max(bottom, spot.y);
        }
        CHECK(std::max(right - left, bottom - top) == Approx(200).epsilon(1e-9));
        CHECK(left + right == Approx(200).epsilon(1e-9));
        CHECK(top + bottom == Approx(200).epsilon(1e-9));
    }
}
