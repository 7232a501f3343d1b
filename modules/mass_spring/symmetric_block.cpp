#include "symmetric_block.hpp"

#include <algorithm>

namespace orbweaver::mass_spring {

SymmetricBlock stiffness_block(const Vec3& l, const Tension& tension, bool clamped) noexcept {
    const double squared = dot(l, l);
    if (squared == 0) return {};
    double across = tension.force / std::sqrt(squared);
    if (clamped) across = std::max(0.0, across);
    const Vec3 along = l * ((tension.slope - across) / squared);
    return {along.x * l.x + across, along.x * l.y, along.x * l.z,
            along.y * l.y + across, along.y * l.z, along.z * l.z + across};
}

SymmetricBlock damping_block(const Spring& spring, const Vec3& l) noexcept {
    const double squared = dot(l, l);
    if (squared == 0) return {};
    const Vec3 along = l * (spring.damping / squared);
    return {along.x * l.x, along.x * l.y, along.x * l.z, along.y * l.y, along.y * l.z, along.z * l.z};
}

}  // namespace orbweaver::mass_spring
