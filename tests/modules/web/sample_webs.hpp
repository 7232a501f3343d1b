#pragma once

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "construction.hpp"
#include "orbweaver/exact_math.hpp"
#include "prestress.hpp"

namespace orbweaver::web::test {

inline const Vec3 kGravity{0, -9.81, 0};
inline constexpr double kMass = 1e-8;

/// Points on a circle in the xy plane, counter-clockwise from the right.
inline std::vector<Vec3> circle(std::size_t count, double radius) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 360.0 * static_cast<double>(i) / static_cast<double>(count);
        points.push_back({radius * cos_degrees(angle), radius * sin_degrees(angle), 0});
    }
    return points;
}

/// The ten anchors of assets/scenes/thesis_web.toml.
inline std::vector<Vec3> thesis_anchors() {
    return {{0, .28, 0},  {-.17, .24, 0}, {-.28, .1, 0}, {-.28, -.09, 0}, {-.18, -.23, 0},
            {0, -.28, 0}, {.17, -.23, 0}, {.28, -.1, 0}, {.28, .09, 0},   {.18, .23, 0}};
}

inline Site site_of(const std::vector<Vec3>& anchors) {
    Diagnostics faults;
    const auto site = survey(anchors, std::nullopt, faults);
    if (!site) throw std::runtime_error(to_string(faults.front()));
    return *site;
}

inline Layout thesis_layout(double irregularity = 0, std::uint64_t seed = 1) {
    Construction how;
    how.move_outer = 75e-3;
    how.irregularity = irregularity;
    return construct(site_of(thesis_anchors()), how, RandomStream(seed, "web/irregularity"));
}

/// The manifest's tensions and axial stiffnesses.
inline Silks default_silks() {
    Silks silks{};
    silks[0] = {3.5e-4, 7e-4};
    silks[1] = {3e-4, 3e-3};
    silks[2] = {3e-5, 8e-4};
    silks[3] = {8e-5, 8e-4};
    silks[4] = {3e-6, 8e-5};
    return silks;
}

/// The reference data's ideal web: `radii` straight radii fixed at the rim, `rings` closed rings `spacing`
/// apart, the innermost of them the hub's.
inline Layout ideal_web(std::size_t radii, std::size_t rings, double spacing) {
    Layout layout;
    layout.spokes.resize(radii);
    for (std::size_t ring = rings + 1; ring >= 1; --ring) {
        const auto points = circle(radii, spacing * static_cast<double>(ring));
        const bool rim = ring == rings + 1;
        for (std::size_t s = 0; s < radii; ++s) {
            const Index added = add_particle(layout, points[s], rim);
            if (!rim) layout.pieces.push_back({layout.spokes[s].back(), added, Kind::radius});
            layout.spokes[s].push_back(added);
            if (rim) layout.frame.push_back(added);
            if (ring == 1) layout.hub.push_back(added);
        }
        for (std::size_t s = 0; s < radii && !rim; ++s)
            layout.pieces.push_back({layout.spokes[s].back(), layout.spokes[(s + 1) % radii].back(),
                                     ring == 1 ? Kind::hub : Kind::spiral});
    }
    return layout;
}

}  // namespace orbweaver::web::test
