#pragma once

#include <cstddef>
#include <variant>

#include "orbweaver/targets.hpp"
#include "orbweaver/vec3.hpp"
#include "surface_ground.hpp"
#include "touch.hpp"

namespace orbweaver::crawler {

/// A level floor.
struct Floor {
    double height = 0;  ///< m

    /// m, below it, of one height or several.
    template <class Real>
    ORBWEAVER_INLINE Real depth(const Real& y) const noexcept {
        return height - y;
    }
    Touch touch(const Vec3& p, std::size_t) const noexcept { return {depth(p.y), {0, 1, 0}}; }
};

/// A floor that ends at a rounded edge, a wall that goes down from there along x = edge, and another floor
/// below.
struct Cliff {
    double height = 0;  ///< m, of the upper floor
    double edge = 0;    ///< m
    double radius = 0;  ///< m, of the edge, at most half of the drop
    double drop = 0;    ///< m, from floor to floor

    Touch touch(const Vec3& p, std::size_t) const noexcept;
};

using Ground = std::variant<Floor, Cliff, SurfaceGround>;

}  // namespace orbweaver::crawler
