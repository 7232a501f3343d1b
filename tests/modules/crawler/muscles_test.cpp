#include "muscles.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

Build sample_build(std::uint32_t segments, bool keeps_volume = true) {
    Build build;
    build.segments = segments;
    build.length = 0.01 * segments;
    build.width = 0.008;
    build.keeps_volume = keeps_volume;
    return build;
}

std::vector<double> lengths(const Build& build, std::span<const Flex> flexes) {
    std::vector<double> rest(Lattice{1, build.segments}.springs_a_body(), -1.0);
    Muscles(build).lengths(flexes, rest);
    return rest;
}

/// `p` about an axis, a coordinate axis of unit length, against the clock for who looks back along it
/// (Rodrigues).
Vec3 turned(const Vec3& p, const Vec3& axis, double angle) {
    return std::cos(angle) * p + std::sin(angle) * cross(axis, p) + (1 - std::cos(angle)) * dot(axis, p) * axis;
}

/// The rings on both sides of one segment as rigid squares of the widths `a` and `b`, their middles `apart` (m)
/// along x, turned about their middles by half of an angle each, one back and one on. y is up, z to the right.
std::vector<Vec3> two_rings(double a, double b, double apart, const Vec3& axis, double angle) {
    std::vector<Vec3> points;
    for (const double end : {-0.5, 0.5})
        for (std::uint32_t j = 0; j < kCorners; ++j) {
            const double width = end < 0 ? a : b;
            const Vec3 corner{0, width * kUp[j], width * kRight[j]};
            points.push_back(Vec3{end * apart, 0, 0} + turned(corner, axis, end * angle));
        }
    return points;
}

/// The largest difference between a segment's springs and distances of points that are so placed.
double misfit(std::span<const double> springs, const std::vector<Vec3>& points) {
    const std::uint32_t ends[][2] = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {1, 2},
                                     {2, 3}, {3, 0}, {1, 0}, {2, 1}, {3, 2}, {0, 3}};
    double largest = 0;
    for (std::size_t i = 0; i < 12; ++i)
        largest =
            std::max(largest, std::abs(springs[i] - distance(points[ends[i][0]], points[4 + ends[i][1]])));
    return largest;
}

constexpr Vec3 kUpwards{0, 1, 0}, kRightwards{0, 0, 1};

}  // namespace

TEST_CASE("muscles at rest leave springs as long as the body was built", "[unit]") {
    for (const bool keeps_volume : {true, false})
        for (const std::uint32_t segments : {2U, 9U}) {
            const Build build = sample_build(segments, keeps_volume);
            const auto rest = lengths(build, std::vector<Flex>(segments));
            const auto network = make_network({1, segments}, build);
            for (std::size_t i = 0; i < rest.size(); ++i)
                CHECK(rest[i] == Approx(network.springs[i].rest_length).epsilon(1e-14));
        }
}

TEST_CASE("a bent segment's springs are distances between rings that have turned by half of the bend each",
          "[unit]") {
    const Build build = sample_build(3);
    const Lattice lattice{1, 3};
    for (const double strain : {-0.2, 0.0, 0.15}) {
        const double width = build.width / std::sqrt(1 + strain), apart = 0.01 * (1 + strain);
        double before[2] = {0, 0};
        for (const double angle : {0.2, 0.1, 0.05}) {
            const double curvature = angle / 0.01;
            // To the left: about what is up; upwards: about what is to the right.
            const std::vector<Flex> to_side(3, {strain, curvature, 0}), upwards(3, {strain, 0, curvature});
            for (int way = 0; way < 2; ++way) {
                const auto rest = lengths(build, way == 0 ? to_side : upwards);
                const auto points = two_rings(width, width, apart, way == 0 ? kUpwards : kRightwards, angle);
                const double off = misfit(std::span(rest).subspan(lattice.segment_spring(0, 1), 12), points);
                // What bending makes of lengths to first order is the angle times half the width, and it is all
                // there; rings that turn come nearer to each other by a part in eight of its square.
                CHECK(off < width * angle * angle / 8);
                CHECK(off > 0);
                if (before[way] > 0) CHECK(before[way] / off == Approx(4).epsilon(0.05));
                before[way] = off;
            }
        }
    }
}

TEST_CASE("a segment that bends both ways at once is as long as both bends make it", "[unit]") {
    const Build build = sample_build(2);
    const Lattice lattice{1, 2};
    const double side = 6, up = -8;  // 1/m: together 10 about the axis between
    const std::vector<Flex> flexes(2, {0.1, side, up});
    const Vec3 axis = 0.6 * kUpwards - 0.8 * kRightwards;
    const auto points = two_rings(0.008 / std::sqrt(1.1), 0.008 / std::sqrt(1.1), 0.011, axis, 0.1);
    const auto rest = lengths(build, flexes);
    CHECK(misfit(std::span(rest).subspan(lattice.segment_spring(0, 1), 12), points) < 0.008 * 0.01 / 8);
}

TEST_CASE("a bend between a wide ring and a narrow one is that of both", "[unit]") {
    const Build build = sample_build(3);
    const Lattice lattice{1, 3};
    std::vector<Flex> flexes(3, {0, 5, 0});  // 0.05 a segment
    flexes[0].strain = 0.3, flexes[2].strain = -0.3;
    const double a = 0.008 / std::sqrt(1.15), b = 0.008 / std::sqrt(0.85);
    const auto rest = lengths(build, flexes);
    CHECK(misfit(std::span(rest).subspan(lattice.segment_spring(0, 1), 12),
                 two_rings(a, b, 0.01, kUpwards, 0.05)) < b * 0.05 * 0.05 / 8);
}

TEST_CASE("a body bent to the left is longer on its right, and one bent upwards below", "[unit]") {
    const Build build = sample_build(4);
    const Lattice lattice{1, 4};
    const double longer = 0.01 * 10 * 0.008 / 2;  // segment times curvature times half the width
    const auto left = lengths(build, std::vector<Flex>(4, {0, 10, 0}));
    const auto upwards = lengths(build, std::vector<Flex>(4, {0, 0, 10}));
    for (std::uint32_t segment = 0; segment < 4; ++segment) {
        const double* to_left = &left[lattice.segment_spring(0, segment)];
        const double* to_up = &upwards[lattice.segment_spring(0, segment)];
        for (std::uint32_t j = 0; j < kCorners; ++j) {
            CHECK(to_left[j] == Approx(0.01 + (kRight[j] > 0 ? longer : -longer)).epsilon(1e-13));
            CHECK(to_up[j] == Approx(0.01 - (kUp[j] > 0 ? longer : -longer)).epsilon(1e-13));
        }
    }
    const double* ring = &left[lattice.ring_spring(0, 2)];  // which bending leaves alone
    for (int j = 0; j < 4; ++j) CHECK(ring[j] == Approx(0.008).epsilon(1e-14));
}

TEST_CASE("a body that lies as its muscles have it keeps its volume where it stretches and shortens",
          "[unit]") {
    for (const bool keeps_volume : {true, false})
        for (const double phase : {0.0, 1.0, 2.5, 4.0}) {
            const std::uint32_t segments = 40;
            const Build build = sample_build(segments, keeps_volume);
            const Lattice lattice{1, segments};
            std::vector<Flex> flexes(segments);
            for (std::uint32_t i = 0; i < segments; ++i)
                flexes[i].strain = 0.2 * std::cos(4 * std::numbers::pi * i / segments + phase);
            const auto rest = lengths(build, flexes);
            // Rings as squares on an axis, as wide as their springs are and a segment's length apart: it is the
            // one body that every spring fits.
            std::vector<Vec3> points;
            double along = 0, steady = 0;
            for (std::uint32_t ring = 0; ring <= segments; ++ring) {
                const double edge = rest[lattice.ring_spring(0, ring)];
                for (std::uint32_t j = 0; j < kCorners; ++j)
                    points.push_back({along, edge * kUp[j], edge * kRight[j]});
                if (ring == segments) break;
                along += 0.01 * (1 + flexes[ring].strain);
                steady += 0.01 * (1 + flexes[ring].strain) * 0.008 * 0.008;
            }
            const auto network = make_network(lattice, build);
            for (std::size_t i = 0; i < rest.size(); ++i) {
                const auto& spring = network.springs[i];
                CHECK(distance(points[spring.a], points[spring.b]) == Approx(rest[i]).epsilon(1e-13));
            }
            const double bar = build.length * build.width * build.width;
            if (keeps_volume) CHECK(volume(lattice, points) == Approx(bar).epsilon(0.01));
            if (!keeps_volume) CHECK(volume(lattice, points) == Approx(steady).epsilon(1e-12));
        }
}

TEST_CASE("a body that is strained all along keeps its volume exactly", "[unit]") {
    for (const double strain : {-0.5, -0.2, 0.2, 1.0}) {
        const auto rest = lengths(sample_build(5), std::vector<Flex>(5, {strain, 0, 0}));
        const double edge = rest[0], along = rest[Lattice::kRingSprings];
        CHECK(along == Approx(0.01 * (1 + strain)).epsilon(1e-14));
        CHECK(edge * edge * along == Approx(0.008 * 0.008 * 0.01).epsilon(1e-13));
    }
}

TEST_CASE("a ring between two segments grows by what both ask on average", "[unit]") {
    std::vector<Flex> flexes(3);
    flexes[1].strain = -0.2;
    const auto rest = lengths(sample_build(3), flexes);
    const Lattice lattice{1, 3};
    for (const std::uint32_t ring : {0U, 1U, 2U, 3U}) {
        const double edge = 0.008 / std::sqrt(ring == 1 || ring == 2 ? 0.9 : 1.0);
        for (std::size_t i = 0; i < Lattice::kRingSprings; ++i)
            CHECK(rest[lattice.ring_spring(0, ring) + i] ==
                  Approx(i < 4 ? edge : std::sqrt(2.0) * edge).epsilon(1e-14));
    }
}
