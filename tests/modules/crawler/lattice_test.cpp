#include "lattice.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

Build sample_build(std::uint32_t segments) {
    Build build;
    build.segments = segments;
    build.length = 0.12;
    build.width = 0.007;
    build.mass = 0.004;
    build.stiffness = 3;
    build.damping = 0.02;
    return build;
}

/// Somewhere, turned some way.
Pose sample_pose(double turn) {
    const Vec3 forward{std::cos(turn), 0.6 * std::sin(turn), -0.8 * std::sin(turn)};
    const Vec3 up = across(Vec3{0.1, 1, 0.3}, forward);
    return {{1 + turn, -2, 3}, forward, up / norm(up)};
}

/// The rank of a matrix of rows, by elimination with the largest pivots. What is left of dependent rows is
/// rounding: pivots of lattices are some 0.1.
std::size_t rank(std::vector<std::vector<double>> rows) {
    std::size_t done = 0;
    for (std::size_t column = 0; column < rows[0].size() && done < rows.size(); ++column) {
        std::size_t best = done;
        for (std::size_t i = done; i < rows.size(); ++i)
            if (std::abs(rows[i][column]) > std::abs(rows[best][column])) best = i;
        if (std::abs(rows[best][column]) < 1e-9) continue;
        std::swap(rows[done], rows[best]);
        for (std::size_t i = done + 1; i < rows.size(); ++i) {
            const double factor = rows[i][column] / rows[done][column];
            for (std::size_t j = column; j < rows[i].size(); ++j) rows[i][j] -= factor * rows[done][j];
        }
        ++done;
    }
    return done;
}

/// m^3, of the space that a trilinear map of the unit cube fills: its Jacobian is of the second degree in each
/// coordinate, so that two points of Gauss along each are exact. `corner(i, j, k)`, each 0 or 1.
template <class Corner>
double trilinear_volume(const Corner& corner) {
    double sum = 0;
    for (int point = 0; point < 8; ++point) {
        double at[3];
        for (int i = 0; i < 3; ++i) at[i] = 0.5 + ((point >> i & 1) != 0 ? 0.5 : -0.5) / std::sqrt(3.0);
        Vec3 slope[3];
        for (int c = 0; c < 8; ++c)
            for (int i = 0; i < 3; ++i) {
                double weight = (c >> i & 1) != 0 ? 1 : -1;
                for (int j = 0; j < 3; ++j)
                    if (j != i) weight *= (c >> j & 1) != 0 ? at[j] : 1 - at[j];
                slope[i] += weight * corner(c & 1, c >> 1 & 1, c >> 2 & 1);
            }
        sum += dot(slope[0], cross(slope[1], slope[2])) / 8;
    }
    return sum;
}

}  // namespace

TEST_CASE("a straight body is a bar about its middle, corners right below second and against the clock",
          "[unit]") {
    const Build build = sample_build(5);
    const Lattice lattice{2, 5};
    const Pose poses[] = {sample_pose(0.4), sample_pose(-2)};
    const auto points = straight_points(lattice, build, poses);
    REQUIRE(points.size() == lattice.points());
    const double right[] = {-1, 1, 1, -1}, up[] = {-1, -1, 1, 1};
    for (std::uint32_t body = 0; body < 2; ++body) {
        const Pose& pose = poses[body];
        CHECK(distance(pose.right(), cross(pose.forward, pose.up)) == 0);
        for (std::uint32_t ring = 0; ring <= 5; ++ring)
            for (std::uint32_t j = 0; j < 4; ++j) {
                const Vec3 from = points[lattice.point(body, ring) + j] - pose.middle;
                CHECK(dot(from, pose.forward) == Approx(-0.06 + 0.024 * ring).margin(1e-15));
                CHECK(dot(from, pose.right()) == Approx(0.0035 * right[j]).margin(1e-15));
                CHECK(dot(from, pose.up) == Approx(0.0035 * up[j]).margin(1e-15));
            }
        for (std::uint32_t ring = 0; ring <= 5; ++ring) {
            const Vec3 middle = ring_middle(&points[lattice.point(body, ring)]) - pose.middle;
            CHECK(distance(middle, (-0.06 + 0.024 * ring) * pose.forward) < 1e-15);
        }
    }
}

TEST_CASE("a straight body is at rest in its springs, sound and whole, and weighs what it is to weigh",
          "[unit]") {
    for (const std::uint32_t segments : {2U, 3U, 20U}) {
        const Build build = sample_build(segments);
        const Lattice lattice{3, segments};
        const Pose poses[] = {sample_pose(0), sample_pose(1), sample_pose(2)};
        const auto points = straight_points(lattice, build, poses);
        const auto network = make_network(lattice, build);
        CHECK(mass_spring::validate(network, points).empty());
        CHECK(mass_spring::count_parts(network) == 3);
        CHECK(network.driven);
        REQUIRE(network.springs.size() == 3 * lattice.springs_a_body());
        for (const auto& spring : network.springs) {
            CHECK(std::abs(distance(points[spring.a], points[spring.b]) - spring.rest_length) < 3e-15);
            CHECK(spring.stiffness == 3);
            CHECK(spring.damping == 0.02);
        }
        for (std::uint32_t body = 0; body < 3; ++body) {
            double mass = 0;
            Vec3 moment;
            for (std::size_t i = 0; i < lattice.points_a_body(); ++i) {
                const std::size_t point = lattice.point(body, 0) + i;
                CHECK(network.fixed[point] == 0);
                mass += network.mass[point];
                moment += network.mass[point] * (points[point] - poses[body].middle);
            }
            CHECK(mass == Approx(0.004).epsilon(1e-13));
            CHECK(norm(moment) < 1e-17);
            for (std::size_t i = 0; i < lattice.points_a_body(); ++i)
                CHECK(network.mass[lattice.point(body, 0) + i] == build.point_mass());
        }
    }
}

TEST_CASE("springs lie along a segment's edges and across its faces, each once, where they are looked for",
          "[unit]") {
    const Lattice lattice{2, 4};
    const auto network = make_network(lattice, sample_build(4));
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const auto& spring : network.springs) CHECK(found.insert(std::minmax(spring.a, spring.b)).second);
    std::size_t expected = 0;
    for (std::uint32_t a = 0; a < lattice.points(); ++a)
        for (std::uint32_t b = a + 1; b < lattice.points(); ++b) {
            const bool one_body = a / lattice.points_a_body() == b / lattice.points_a_body();
            const std::uint32_t rings = b / 4 - a / 4;
            // All pairs of a segment but those across its middle.
            const bool opposite = (b % 4 + 4 - a % 4) % 4 == 2;
            const bool joined = one_body && (rings == 0 || (rings == 1 && !opposite));
            CHECK(found.count({a, b}) == (joined ? 1 : 0));
            expected += joined ? 1 : 0;
        }
    CHECK(found.size() == expected);

    for (std::uint32_t body = 0; body < 2; ++body)
        for (std::uint32_t ring = 0; ring < lattice.rings(); ++ring) {
            const auto at = static_cast<std::uint32_t>(lattice.point(body, ring));
            const auto* of_ring = &network.springs[lattice.ring_spring(body, ring)];
            const std::uint32_t edges[][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2}, {1, 3}};
            for (int i = 0; i < 6; ++i) {
                CHECK(of_ring[i].a == at + edges[i][0]);
                CHECK(of_ring[i].b == at + edges[i][1]);
            }
            if (ring == lattice.segments) break;
            const auto* of_segment = &network.springs[lattice.segment_spring(body, ring)];
            const std::uint32_t on = at + 4;
            const std::uint32_t along[][2] = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {1, 2},
                                              {2, 3}, {3, 0}, {1, 0}, {2, 1}, {3, 2}, {0, 3}};
            for (int i = 0; i < 12; ++i) {
                CHECK(of_segment[i].a == at + along[i][0]);
                CHECK(of_segment[i].b == on + along[i][1]);
            }
        }
}

TEST_CASE("a body gives way to nothing but being moved and turned as a whole", "[unit]") {
    const Lattice lattice{1, 3};
    const Build build = sample_build(3);
    const Pose pose = sample_pose(0.7);
    const auto points = straight_points(lattice, build, {&pose, 1});
    // How each spring's length changes as each coordinate does.
    std::vector<std::vector<double>> rows;
    for (const auto& spring : make_network(lattice, build).springs) {
        std::vector<double> row(3 * points.size(), 0.0);
        const Vec3 along = (points[spring.a] - points[spring.b]) / spring.rest_length;
        const double parts[] = {along.x, along.y, along.z};
        for (std::size_t i = 0; i < 3; ++i) {
            row[3 * spring.a + i] = parts[i];
            row[3 * spring.b + i] = -parts[i];
        }
        rows.push_back(row);
    }
    CHECK(rank(rows) == 3 * points.size() - 6);
}

TEST_CASE("the volume is that of the bar, wherever it is and however it is sheared", "[unit]") {
    const Build build = sample_build(6);
    const Lattice lattice{1, 6};
    const double bar = 0.12 * 0.007 * 0.007;
    for (const double turn : {0.0, 0.9, -2.5}) {
        const Pose pose = sample_pose(turn);
        auto points = straight_points(lattice, build, {&pose, 1});
        CHECK(volume(lattice, points) == Approx(bar).epsilon(1e-12));
        // A linear map, of determinant 1.2 * (0.9 * 1.1 - 0.2 * 0.3) - 0.4 * (0.1 * 1.1 - 0.2 * 0.5)
        //     + 0.1 * (0.1 * 0.3 - 0.9 * 0.5).
        for (Vec3& p : points)
            p = {1.2 * p.x + 0.4 * p.y + 0.1 * p.z, 0.1 * p.x + 0.9 * p.y + 0.2 * p.z,
                 0.5 * p.x + 0.3 * p.y + 1.1 * p.z};
        CHECK(volume(lattice, points) == Approx(1.07 * bar).epsilon(1e-12));
    }
}

TEST_CASE("the volume of a warped body is that of its segments as trilinear maps", "[unit]") {
    const RandomStream random(4, "warped");
    const Build build = sample_build(5);
    const Lattice lattice{1, 5};
    const Pose pose = sample_pose(0.3);
    std::uint64_t n = 0;
    for (int round = 0; round < 50; ++round) {
        auto points = straight_points(lattice, build, {&pose, 1});
        for (Vec3& p : points) {
            const double x = random.uniform(n++, -1, 1), y = random.uniform(n++, -1, 1);
            p += 0.002 * Vec3{x, y, random.uniform(n++, -1, 1)};
        }
        double expected = 0;
        for (std::size_t segment = 0; segment < 5; ++segment)
            expected -= trilinear_volume([&](int forward, int right, int up) {  // a left-handed order
                const int corner = up != 0 ? 3 - right : right;
                return points[4 * (segment + static_cast<std::size_t>(forward)) +
                              static_cast<std::size_t>(corner)];
            });
        CHECK(volume(lattice, points) == Approx(expected).epsilon(1e-11));
    }
}
