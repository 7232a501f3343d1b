#pragma once

#include <span>

namespace orbweaver::spider {

/// A foot that carries, seen along the body's up, from its center of mass; m.
struct SupportPoint {
    double forward = 0, right = 0;
};

/// The static stability margin (McGhee and Frank 1968), and the side of the feet's convex hull that it is
/// measured from.
struct Support {
    /// m, from the center of mass to the nearest side; below 0 where it is outside: then the farthest that it
    /// is beyond a side. Minus infinity where feet span nothing.
    double margin = 0;
    SupportPoint inward;  ///< unit, across that side
};
Support support_of(std::span<const SupportPoint> feet) noexcept;

}  // namespace orbweaver::spider
