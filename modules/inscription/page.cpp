#include "page.hpp"

#include <algorithm>
#include <limits>

namespace orbweaver::inscription {

Spot Page::spot(const Vec3& point) const noexcept {
    const Vec3 from_middle = point - middle;
    const double half = 0.5 * side;
    return {half + dot(from_middle, right) / pixel, half - dot(from_middle, up) / pixel};
}

Vec3 Page::point(const Spot& spot) const noexcept {
    const double half = 0.5 * side;
    return middle + (spot.x - half) * pixel * right + (half - spot.y) * pixel * up;
}

Page page_of(const WebAtRest& web, std::uint32_t side) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    double left = kInfinity, bottom = kInfinity, far_right = -kInfinity, top = -kInfinity;
    for (const Vec3& point : web.points) {
        const Vec3 from_hub = point - web.center;
        const double x = dot(from_hub, web.right), y = dot(from_hub, web.up);
        left = std::min(left, x);
        far_right = std::max(far_right, x);
        bottom = std::min(bottom, y);
        top = std::max(top, y);
    }
    return {web.center + 0.5 * (left + far_right) * web.right + 0.5 * (bottom + top) * web.up, web.right,
            web.up, std::max(far_right - left, top - bottom) / side, side};
}

}  // namespace orbweaver::inscription
