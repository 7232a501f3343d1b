#include "measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace orbweaver::web {

namespace {

/// Where the spiral crosses one spoke, as distances from the hub's center.
struct Crossings {
    std::size_t count = 0;
    double inner = std::numeric_limits<double>::infinity();
    double outer = 0;
    double mesh() const noexcept { return (outer - inner) / static_cast<double>(count - 1); }
};

std::vector<std::uint8_t> on_spiral(const Layout& layout) {
    std::vector<std::uint8_t> found(layout.positions.size(), 0);
    for (const Piece& piece : layout.pieces)
        if (piece.kind == Kind::spiral) found[piece.a] = found[piece.b] = 1;
    return found;
}

/// The hub's middle as it is now.
PlanePoint hub_middle(const Layout& layout, std::span<const Vec3> positions) {
    Vec3 sum;
    for (const Index i : layout.hub) sum += positions[i];
    return layout.plane.project(sum / static_cast<double>(layout.hub.size()));
}

/// The spoke that leaves the hub most nearly in this direction and is crossed twice at least.
const Crossings* quadrant(std::span<const Crossings> crossings, std::span<const PlanePoint> directions,
                          const PlanePoint& wanted) {
    const Crossings* best = nullptr;
    double nearest = -2;
    for (std::size_t s = 0; s < crossings.size(); ++s) {
        const double cosine = directions[s].x * wanted.x + directions[s].y * wanted.y;
        if (crossings[s].count < 2 || cosine <= nearest) continue;
        nearest = cosine;
        best = &crossings[s];
    }
    return best;
}

}  // namespace

ThreadMeasures measure_threads(const mass_spring::Network& network, std::span<const Vec3> positions) {
    ThreadMeasures measures;
    for (const double mass : network.mass) measures.total_mass += mass;
    for (const mass_spring::Spring& spring : network.springs) {
        const double length = distance(positions[spring.a], positions[spring.b]);
        measures.silk_length += length;
        if (length < spring.rest_length * (1 - 1e-12)) ++measures.slack_springs;
        if (spring.rest_length > 0)
            measures.max_strain = std::max(measures.max_strain, length / spring.rest_length - 1);
    }
    return measures;
}

OrbMeasures measure_orb(const Layout& layout, std::span<const Vec3> positions) {
    OrbMeasures measures;
    measures.radii = layout.spokes.size();
    const std::vector<std::uint8_t> spiral = on_spiral(layout);
    const PlanePoint hub = hub_middle(layout, positions);
    const double inf = std::numeric_limits<double>::infinity();
    PlanePoint low{inf, inf};
    PlanePoint high{-inf, -inf};
    std::vector<Crossings> crossings(layout.spokes.size());
    std::vector<PlanePoint> directions(layout.spokes.size());
    double inner_sum = 0;
    double inner_count = 0;
    for (std::size_t s = 0; s < layout.spokes.size(); ++s) {
        const PlanePoint end = layout.plane.project(positions[layout.spokes[s].front()]);
        const double way = std::hypot(end.x - hub.x, end.y - hub.y);
        directions[s] = {(end.x - hub.x) / way, (end.y - hub.y) / way};
        Crossings& on_spoke = crossings[s];
        for (const Index i : layout.spokes[s]) {
            if (spiral[i] == 0) continue;
            const PlanePoint p = layout.plane.project(positions[i]);
            const PlanePoint d{p.x - hub.x, p.y - hub.y};
            low = {std::min(low.x, d.x), std::min(low.y, d.y)};
            high = {std::max(high.x, d.x), std::max(high.y, d.y)};
            const double r = std::sqrt(d.x * d.x + d.y * d.y);
            on_spoke.inner = std::min(on_spoke.inner, r);
            on_spoke.outer = std::max(on_spoke.outer, r);
            ++on_spoke.count;
        }
        measures.spiral_turns += static_cast<double>(on_spoke.count) / static_cast<double>(crossings.size());
        if (on_spoke.count == 0) continue;
        inner_sum += on_spoke.inner;
        inner_count += 1;
    }
    if (inner_count == 0) return measures;
    const double free_radius = inner_sum / inner_count;
    measures.capture_area =
        std::numbers::pi * ((high.x - low.x) * (high.y - low.y) / 4 - free_radius * free_radius);
    measures.asymmetry = (-low.y - high.y) / (high.y - low.y);
    double quadrants = 0;
    for (const PlanePoint direction :
         {PlanePoint{0, 1}, PlanePoint{0, -1}, PlanePoint{1, 0}, PlanePoint{-1, 0}}) {
        const Crossings* found = quadrant(crossings, directions, direction);
        if (found == nullptr) continue;
        measures.mesh_width += found->mesh();
        quadrants += 1;
    }
    if (quadrants > 0) measures.mesh_width /= quadrants;
    return measures;
}

double frame_area(const Layout& layout, std::span<const Vec3> positions) {
    const PlanePoint first = layout.plane.project(positions[layout.frame.front()]);
    double twice = 0;
    for (std::size_t i = 1; i + 1 < layout.frame.size(); ++i)
        twice += turn(first, layout.plane.project(positions[layout.frame[i]]),
                      layout.plane.project(positions[layout.frame[i + 1]]));
    return twice / 2;
}

double largest_residual(const mass_spring::Network& network, std::span<const Vec3> forces) {
    double largest = 0;
    for (std::size_t i = 0; i < network.size(); ++i)
        if (network.fixed[i] == 0) largest = std::max(largest, norm(forces[i]));
    return largest;
}

}  // namespace orbweaver::web
