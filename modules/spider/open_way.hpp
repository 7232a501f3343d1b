#pragma once

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::spider {

/// Whether somebody on `ground` can go `length` m along `way` (unit, across up): no border stops it, and feet
/// hold on where it ends.
bool is_open(const Surface& surface, const Footing& ground, const Vec3& way, double length,
             const Vec3& gravity) noexcept;

/// The open way nearest to `wanted` (m/s, across up) for the next `time` s, as fast, of those 30 degrees apart;
/// `wanted` itself where none is open.
Vec3 open_way(const Surface& surface, const Footing& ground, const Vec3& wanted, double time,
              const Vec3& gravity) noexcept;

}  // namespace orbweaver::spider
