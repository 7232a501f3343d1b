#include "lattice.hpp"

namespace orbweaver::crawler {

namespace {

/// Six times the volume between the origin and a face, which may be warped.
double wedge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
    const Vec3 middle = 0.25 * (a + b + c + d);
    return dot(middle, cross(a, b) + cross(b, c) + cross(c, d) + cross(d, a));
}

class Builder {
public:
    explicit Builder(const Build& build) : build_(build) {}

    void add_body(const Lattice& lattice, std::uint32_t body) {
        for (std::uint32_t ring = 0; ring < lattice.rings(); ++ring) {
            const auto at = static_cast<std::uint32_t>(lattice.point(body, ring));
            add_ring(at);
            if (ring < lattice.segments) add_segment(at);
        }
    }
    std::vector<mass_spring::Spring> springs;

private:
    static std::uint32_t next(std::uint32_t corner) noexcept { return (corner + 1) % kCorners; }
    void add(std::uint32_t a, std::uint32_t b, double length) {
        springs.push_back({a, b, length, build_.stiffness, build_.damping});
    }
    void add_ring(std::uint32_t at) {
        for (std::uint32_t j = 0; j < kCorners; ++j) add(at + j, at + next(j), build_.width);
        for (std::uint32_t j = 0; j < 2; ++j) add(at + j, at + j + 2, std::sqrt(2.0) * build_.width);
    }
    void add_segment(std::uint32_t at) {
        const double segment = build_.segment();
        const double across = std::sqrt(segment * segment + build_.width * build_.width);
        const std::uint32_t on = at + kCorners;
        for (std::uint32_t j = 0; j < kCorners; ++j) add(at + j, on + j, segment);
        for (std::uint32_t j = 0; j < kCorners; ++j) add(at + j, on + next(j), across);
        for (std::uint32_t j = 0; j < kCorners; ++j) add(at + next(j), on + j, across);
    }

    const Build& build_;
};

}  // namespace

mass_spring::Network make_network(const Lattice& lattice, const Build& build) {
    mass_spring::Network network;
    network.driven = true;
    network.fixed.assign(lattice.points(), 0);
    Builder builder(build);
    builder.springs.reserve(lattice.bodies * lattice.springs_a_body());
    network.mass.assign(lattice.points(), build.point_mass());
    for (std::uint32_t body = 0; body < lattice.bodies; ++body) builder.add_body(lattice, body);
    network.springs = std::move(builder.springs);
    return network;
}

void add_ring_points(const Pose& ring, double width, std::vector<Vec3>& points) {
    const Vec3 right = ring.right();
    for (std::uint32_t j = 0; j < kCorners; ++j)
        points.push_back(ring.middle + width * kRight[j] * right + width * kUp[j] * ring.up);
}

std::vector<Vec3> straight_points(const Lattice& lattice, const Build& build, std::span<const Pose> poses) {
    std::vector<Vec3> points;
    points.reserve(lattice.points());
    for (const Pose& pose : poses)
        for (std::uint32_t ring = 0; ring < lattice.rings(); ++ring) {
            const double along = build.segment() * ring - build.length / 2;
            add_ring_points({pose.middle + along * pose.forward, pose.forward, pose.up}, build.width, points);
        }
    return points;
}

double volume(const Lattice& lattice, std::span<const Vec3> points) noexcept {
    const std::size_t last = points.size() - kCorners;
    const Vec3 origin = points[0];  // near by, so that differences are exact enough
    const auto at = [&](std::size_t i) { return points[i] - origin; };
    double sixfold =
        wedge(at(0), at(1), at(2), at(3)) + wedge(at(last + 3), at(last + 2), at(last + 1), at(last));
    for (std::uint32_t segment = 0; segment < lattice.segments; ++segment)
        for (std::uint32_t j = 0; j < kCorners; ++j) {
            const std::size_t a = std::size_t{kCorners} * segment + j;
            const std::size_t b = std::size_t{kCorners} * segment + (j + 1) % kCorners;
            sixfold += wedge(at(a), at(a + kCorners), at(b + kCorners), at(b));
        }
    return sixfold / 6;
}

}  // namespace orbweaver::crawler
