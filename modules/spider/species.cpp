#include "species.hpp"

#include <cmath>

namespace orbweaver::spider {

std::vector<Leg> legs_of(const Species& species) {
    std::vector<Leg> legs;
    for (const Limb& limb : species.limbs) legs.push_back(limb.leg);
    return legs;
}

double mean_leg_length(const Species& species) noexcept {
    double sum = 0;
    for (const Limb& limb : species.limbs) sum += limb.leg.length;
    return sum / static_cast<double>(species.limbs.size());
}

Vec3 stance_of(const Limb& limb) noexcept {
    constexpr double kStretch = 0.72;  // of the leg's length
    const Vec3 out = limb.home - limb.base;
    const double level = std::sqrt(out.x * out.x + out.z * out.z);
    const double least = kStretch * kStretch * limb.leg.length * limb.leg.length - out.y * out.y;
    const double wanted = least > 0 ? std::sqrt(least) : level;
    const double share = level > wanted ? wanted / level : 1;
    return limb.base + Vec3{share * out.x, out.y, share * out.z};
}

Vec3 to_limb(const Limb& limb, const Vec3& point) noexcept {
    const Vec3 d = point - limb.base;
    return {dot(d, limb.axes.x), dot(d, limb.axes.y), dot(d, limb.axes.z)};
}

Vec3 to_body(const Limb& limb, const Vec3& point) noexcept {
    return limb.base + point.x * limb.axes.x + point.y * limb.axes.y + point.z * limb.axes.z;
}

}  // namespace orbweaver::spider
