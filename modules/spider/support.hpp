#pragma once

#include <span>

namespace orbweaver::spider {

/// A foot that carries, seen along the body's up, from its center of mass; m.
struct SupportPoint {
    double forward = 0, right = 0;
};

/// m: the static stability margin (McGhee and Frank 1968), from the center of mass to the nearest side of the
/// feet's convex hull; below 0 where it is outside: then the farthest that it is beyond a side. Minus infinity
/// where fewer than three feet span nothing.
double stability_margin(std::span<const SupportPoint> feet) noexcept;

}  // namespace orbweaver::spider
