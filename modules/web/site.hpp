#pragma once

#include <optional>
#include <span>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/vec3.hpp"
#include "plane.hpp"

namespace orbweaver::web {

/// Where a web is to hang: sound anchors, in counter-clockwise order as seen against the normal, and the
/// point that its construction works towards.
struct Site {
    std::vector<Vec3> anchors;  ///< m
    Plane plane;                ///< through `center`
    Vec3 center;                ///< m
    bool center_given = false;  ///< the scene chose the center, so the hub goes there too
};

inline constexpr std::size_t kMostAnchors = 1000;

/// Examines the attachment points. The center is the one given; else the middle of the anchors' bounding
/// box in their plane (thesis, figure 5.5); else, where that does not see every frame thread from inside,
/// the centroid of their polygon. Nothing when there is a fault; each fault is a sentence.
std::optional<Site> survey(std::span<const Vec3> anchors, std::optional<Vec3> center, Diagnostics& faults);

}  // namespace orbweaver::web
