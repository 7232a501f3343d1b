#include "species.hpp"

namespace orbweaver::spider {

double mean_leg_length(const Species& species) noexcept {
    double sum = 0;
    for (const Limb& limb : species.limbs) sum += limb.leg.length;
    return sum / static_cast<double>(species.limbs.size());
}

Vec3 to_limb(const Limb& limb, const Vec3& point) noexcept {
    const Vec3 d = point - limb.base;
    return {dot(d, limb.axes.x), dot(d, limb.axes.y), dot(d, limb.axes.z)};
}

Vec3 to_body(const Limb& limb, const Vec3& point) noexcept {
    return limb.base + point.x * limb.axes.x + point.y * limb.axes.y + point.z * limb.axes.z;
}

}  // namespace orbweaver::spider
