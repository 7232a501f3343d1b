#include "sketch.hpp"

namespace orbweaver::crawler {

void add_sketch(const Lattice& lattice, const Build& build, double gravity, std::span<const Vec3> x,
                std::span<const Vec3> reaction, std::vector<SketchLine>& lines) {
    constexpr std::array<float, 3> kSpine{1, 0.85F, 0.2F}, kForce{0.2F, 0.8F, 1};
    constexpr double kMasses = 10;
    for (std::uint32_t body = 0; body < lattice.bodies; ++body)
        for (std::uint32_t ring = 0; ring < lattice.segments; ++ring)
            lines.push_back({ring_middle(&x[lattice.point(body, ring)]),
                             ring_middle(&x[lattice.point(body, ring + 1)]), kSpine});
    if (!(gravity > 0)) return;
    const double scale = 2 * build.segment() / (kMasses * build.point_mass() * gravity);
    for (std::size_t i = 0; i < x.size(); ++i)
        if (dot(reaction[i], reaction[i]) > 0) lines.push_back({x[i], x[i] + scale * reaction[i], kForce});
}

}  // namespace orbweaver::crawler
