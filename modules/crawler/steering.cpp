#include "steering.hpp"

#include <algorithm>

namespace orbweaver::crawler {

double turn_towards(const Vec3& position, const Vec3& forward, const Vec3& up, const Vec3& aim) noexcept {
    constexpr double kGain = 2;  // turned as far as it can at 30 degrees
    const Vec3 way = across(aim - position, up);
    const double far = norm(way);
    if (!(far > 0)) return 0;
    const double left = dot(way, cross(up, forward)) / far;
    if (dot(way, forward) <= 0) return left < 0 ? -1 : 1;
    return std::clamp(kGain * left, -1.0, 1.0);
}

}  // namespace orbweaver::crawler
