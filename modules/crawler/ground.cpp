#include "ground.hpp"

#include <algorithm>

namespace orbweaver::crawler {

Touch Cliff::touch(const Vec3& p, std::size_t) const noexcept {
    const double below_floor = height - p.y, behind_wall = edge - p.x;
    const Touch lower{height - drop - p.y, {0, 1, 0}};
    // Beyond where the rounding begins, both ways, its axis is what counts.
    if (below_floor < radius && behind_wall < radius) {
        const Vec3 out{radius - behind_wall, radius - below_floor, 0};
        const double far = norm(out);
        return far > 0 && radius - far > lower.depth ? Touch{radius - far, out / far} : lower;
    }
    const Touch upper =
        below_floor < behind_wall ? Touch{below_floor, {0, 1, 0}} : Touch{behind_wall, {1, 0, 0}};
    return upper.depth > lower.depth ? upper : lower;
}

}  // namespace orbweaver::crawler
