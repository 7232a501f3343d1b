#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contender.hpp"

namespace orbweaver::peers {

/// m, the errors that contenders are compared at.
inline constexpr std::array<double, 3> kTargets{1e-4, 1e-6, 1e-8};

struct Point {
    double setting = 0;
    double error = 0;    ///< m, the largest of a particle's position at the end
    double seconds = 0;  ///< of processor time
};

/// A contender's runs, and of each target the cheapest that is within it, repeated.
struct Sweep {
    Contender contender;
    std::vector<Point> points;
    std::array<std::optional<Point>, kTargets.size()> cheapest;

    Point most_accurate() const;
};

/// From the contender's first setting on, until the last target is met, nothing is won any more, or a run
/// has taken longer than `patience` seconds.
Sweep sweep(const Contender& contender, const std::vector<Vec3>& exact, double patience);

}  // namespace orbweaver::peers
