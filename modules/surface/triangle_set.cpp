#include "triangle_set.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::surface {

Vec3 extreme_normal(const std::array<Vec3, 3>& p) noexcept {
    const Vec3 a = p[1] - p[0];
    const Vec3 b = p[2] - p[0];
    const double largest =
        std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
    return unit(cross(a / largest, b / largest));
}

}  // namespace orbweaver::surface
