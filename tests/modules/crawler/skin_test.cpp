#include "skin.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <vector>

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

constexpr const char* kKinds[] = {"worm", "snake", "caterpillar"};
constexpr std::uint32_t kTips = 3;

Build build_of(std::uint32_t segments) {
    Build build;
    build.segments = segments;
    build.length = 0.1;
    build.width = 0.01;
    return build;
}

/// Straight bodies along x, side by side, whose undersides lie at y = 0, and their skin.
struct Dressed {
    Build build = build_of(20);
    Lattice lattice{3, 20};
    std::vector<Vec3> masses;
    Skin skin;
    std::vector<Vec3> points;

    explicit Dressed(const char* kind) : skin(kind, lattice, build) {
        std::vector<Pose> poses;
        for (int i = 0; i < 3; ++i) poses.push_back({{0.5, build.width / 2, 0.1 * i}, {1, 0, 0}, {0, 1, 0}});
        masses = straight_points(lattice, build, poses);
        const auto made = skin.points(masses);
        points.assign(made.begin(), made.end());
    }
    /// The four of a ring of a body, tips counted.
    std::span<const Vec3> ring(std::size_t body, std::size_t number) const {
        const PatchLayout layout = skin_layout(lattice);
        return std::span(points).subspan((body * layout.rings + number) * layout.sides, layout.sides);
    }
};

}  // namespace

TEST_CASE("a skin has a ring of points for each of the lattice, and three that close it at each end",
          "[unit]") {
    for (const std::uint32_t segments : {3u, 20u, 200u}) {
        const Lattice lattice{2, segments};
        const PatchLayout layout = skin_layout(lattice);
        CHECK(layout.bodies == 2);
        CHECK(layout.rings == segments + 1 + 2 * kTips);
        CHECK(layout.sides == 4);
    }
    const Dressed worm("worm");
    const PatchLayout layout = skin_layout(worm.lattice);
    CHECK(worm.points.size() == layout.bodies * layout.rings * layout.sides);
}

TEST_CASE("a skin ends in one point beyond each end of its body", "[unit]") {
    for (const char* kind : kKinds) {
        const Dressed dressed(kind);
        const std::size_t rings = skin_layout(dressed.lattice).rings;
        for (std::size_t body = 0; body < 3; ++body) {
            for (std::size_t tip = 0; tip < kTips; ++tip)
                for (std::size_t side = 0; side < 4; ++side) {
                    CHECK(dressed.ring(body, tip)[side] == dressed.ring(body, 0)[0]);
                    CHECK(dressed.ring(body, rings - 1 - tip)[side] == dressed.ring(body, rings - 1)[0]);
                }
            const double half = dressed.build.segment() / 2;
            CHECK(dressed.ring(body, 0)[0].x == Approx(0.45 - half));
            CHECK(dressed.ring(body, rings - 1)[0].x == Approx(0.55 + half));
            CHECK(dressed.ring(body, 0)[0].z == Approx(0.1 * static_cast<double>(body)).margin(1e-12));
        }
    }
}

TEST_CASE("from the head, points go counter-clockwise, so that a skin is seen from outside", "[unit]") {
    for (const char* kind : kKinds) {
        const Dressed dressed(kind);
        for (std::size_t number = kTips; number < kTips + 21; ++number) {
            const auto ring = dressed.ring(0, number);
            const Vec3 middle = ring_middle(ring.data());
            for (std::size_t side = 0; side < 4; ++side)
                CHECK(cross(ring[side] - middle, ring[(side + 1) % 4] - middle).x > 0);
        }
    }
}

TEST_CASE("thinner parts of a body lie on the ground as thick ones do", "[unit]") {
    for (const char* kind : kKinds) {
        CAPTURE(kind);
        const Dressed dressed(kind);
        double thinnest = 1, thickest = 0;
        for (std::size_t number = kTips; number < kTips + 21; ++number) {
            const auto ring = dressed.ring(0, number);
            // Of the spline around a ring, between its two points below and those above them.
            const double below = (23 * (ring[0].y + ring[1].y) + ring[2].y + ring[3].y) / 48;
            const double above = (23 * (ring[2].y + ring[3].y) + ring[0].y + ring[1].y) / 48;
            const double thickness = (above - below) / dressed.build.width;
            CHECK(std::abs(below) < 0.02 * dressed.build.width);
            thinnest = std::min(thinnest, thickness);
            thickest = std::max(thickest, thickness);
        }
        CHECK(thickest < 1.01);
        CHECK(thinnest > 0.1);
        CHECK(thinnest < 0.9 * thickest);
    }
}

TEST_CASE("a skin follows the body that it is drawn from", "[unit]") {
    Dressed snake("snake");
    const Vec3 by{0.3, -0.2, 0.1};
    for (Vec3& each : snake.masses) each += by;
    const auto moved = snake.skin.points(snake.masses);
    REQUIRE(moved.size() == snake.points.size());
    for (std::size_t i = 0; i < moved.size(); ++i) CHECK(distance(moved[i], snake.points[i] + by) < 1e-12);
}

TEST_CASE("maps have rows by the segments up to a most, four bytes a texel and a relief in widths", "[unit]") {
    struct Case {
        std::uint32_t segments, rows;
    };
    for (const char* kind : kKinds)
        for (const Case each : {Case{3, 72}, {20, 480}, {90, 2048}}) {
            CAPTURE(kind, each.segments);
            const Build build = build_of(each.segments);
            const Skin skin(kind, {1, each.segments}, build);
            const PatchMap map = skin.map();
            CHECK(map.columns == 128);
            CHECK(map.rows == each.rows);
            CHECK(map.texels.size() == std::size_t{4} * map.columns * map.rows);
            CHECK(map.relief > 0.02 * build.width);
            CHECK(map.relief < 0.2 * build.width);
            CHECK(map.gloss > 0);
            CHECK(map.gloss < 1);
            CHECK(skin.memory_bytes() >= map.texels.size());
        }
}

TEST_CASE("the three kinds look different, each by itself is relief and pattern, and others look like worms",
          "[unit]") {
    std::set<std::vector<std::uint8_t>> maps;
    for (const char* kind : kKinds) {
        CAPTURE(kind);
        const Skin skin(kind, {1, 20}, build_of(20));
        const auto texels = skin.map().texels;
        maps.emplace(texels.begin(), texels.end());
        for (std::size_t channel = 0; channel < 4; ++channel) {
            std::uint8_t least = 255, most = 0;
            for (std::size_t i = channel; i < texels.size(); i += 4) {
                least = std::min(least, texels[i]);
                most = std::max(most, texels[i]);
            }
            CHECK(most - least > 60);
        }
    }
    CHECK(maps.size() == 3);
    const Skin slug("slug", {1, 20}, build_of(20)), worm("worm", {1, 20}, build_of(20));
    CHECK(std::equal(slug.map().texels.begin(), slug.map().texels.end(), worm.map().texels.begin()));
}

TEST_CASE("a map has no seam where it closes around the body", "[unit]") {
    for (const char* kind : kKinds) {
        CAPTURE(kind);
        const Skin skin(kind, {1, 20}, build_of(20));
        const auto texels = skin.map().texels;
        const auto step_between = [&](std::uint32_t a, std::uint32_t b) {
            double sum = 0;
            for (std::uint32_t row = 0; row < skin.map().rows; ++row)
                for (std::size_t channel = 0; channel < 4; ++channel)
                    sum += std::abs(texels[4 * (std::size_t{row} * 128 + a) + channel] -
                                    texels[4 * (std::size_t{row} * 128 + b) + channel]);
            return sum;
        };
        double most = 0;
        for (std::uint32_t column = 0; column + 1 < 128; ++column)
            most = std::max(most, step_between(column, column + 1));
        CHECK(step_between(127, 0) <= most);
    }
}
