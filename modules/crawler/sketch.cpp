#include "sketch.hpp"

#include "orbweaver/exact_math.hpp"

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

void add_cliff(const Cliff& cliff, double reach, std::vector<SketchLine>& lines) {
    constexpr std::array<float, 3> kRock{0.62F, 0.6F, 0.55F};
    constexpr int kArc = 6, kProfiles = 12;
    const double below = cliff.height - cliff.drop;
    std::vector<Vec3> profile{{cliff.edge - reach, cliff.height, 0}};
    for (int i = 0; i <= kArc; ++i) {
        const double angle = 90.0 * i / kArc;
        profile.push_back({cliff.edge - cliff.radius * (1 - sin_degrees(angle)),
                           cliff.height - cliff.radius * (1 - cos_degrees(angle)), 0});
    }
    profile.push_back({cliff.edge, below, 0});
    profile.push_back({cliff.edge + reach, below, 0});
    const Vec3 aside{0, 0, reach};
    for (int row = 0; row <= kProfiles; ++row) {
        const Vec3 at = (2.0 * row / kProfiles - 1) * aside;
        for (std::size_t i = 1; i < profile.size(); ++i)
            lines.push_back({profile[i - 1] + at, profile[i] + at, kRock});
    }
    for (const Vec3& each : profile) lines.push_back({each - aside, each + aside, kRock});
}

}  // namespace orbweaver::crawler
