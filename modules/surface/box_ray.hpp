#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "watertight.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// A ray in the tree's coordinates, begun where it enters the cube [-1, 1]: single precision then rounds by no
/// more than 2^-21 of the tree's half size in all (positions up to 1, three products, one difference), whatever
/// the distance that the ray comes from. Planes are moved outwards by twice that, and by the rounding of the
/// triangle test, which grows with that distance. The unit of distances is that in which the direction's
/// longest component is 1 or more, and less than 2.
struct BoxRay {
    bool meets = true;
    std::array<std::size_t, 3> near_plane{}, far_plane{};
    std::array<float, 3> inverse{}, near{}, far{};  ///< a plane p is met at p * inverse - near, or far
    double start = 0;                               ///< where it enters
    double per_unit;                                ///< our distances in one length of its direction

    ORBWEAVER_INLINE BoxRay(const WideFrame& frame, const SurfaceRay& ray) noexcept {
        const double power = power_to_one(ray.direction);
        const double per_size = 1 / frame.size;
        per_unit = per_size / power;
        const Lanes origin = lanes_of(ray.origin, 0), middle = lanes_of(frame.middle, 0);
        const Lanes direction = lanes_of(ray.direction, 1);
        const Lanes forwards = direction < 0 ? in_all(-1) : in_all(1);
        const Lanes inverses =
            forwards * least((1 / (direction * forwards + 0.0)) * (1 / power), in_all(kSteepest));
        Lanes at = (origin - middle) * per_size;
        double slack = slack_of(1, largest(middle) * per_size + 1);
        if (const double away = largest(at); away > 1) {
            slack = slack_of(away, largest(origin) * per_size);
            enter(at, inverses, inverses * forwards * (1 + 2 * slack), ray.reach * per_unit);
            at += start * power * direction;
        }
        const Lanes outwards = slack * forwards;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t backwards = forwards[i] < 0 ? 1 : 0;
            near_plane[i] = 2 * i + backwards;
            far_plane[i] = 2 * i + 1 - backwards;
            inverse[i] = static_cast<float>(inverses[i]);
            near[i] = static_cast<float>(at[i] + outwards[i]) * inverse[i];
            far[i] = static_cast<float>(at[i] - outwards[i]) * inverse[i];
        }
    }

    /// A distance in lengths of the direction as ours from where it enters, rounded up.
    ORBWEAVER_INLINE float in_tree(double distance) const noexcept {
        constexpr float kUp = 1.000001F;
        return static_cast<float>(distance * per_unit - start) * kUp + 0x1p-20F;
    }

private:
    static constexpr double kSteepest = 0x1p96;  // inverse of a component that is taken for 0: still a single

    ORBWEAVER_INLINE static Lanes lanes_of(const Vec3& v, double last) noexcept {
        return Lanes{v.x, v.y, v.z, last};
    }
    ORBWEAVER_INLINE static Lanes least(const Lanes& a, const Lanes& b) noexcept { return a < b ? a : b; }
    ORBWEAVER_INLINE static double largest(const Lanes& of) noexcept {
        return std::max({std::abs(of[0]), std::abs(of[1]), std::abs(of[2])});
    }
    /// For a ray from `away` off the middle, and `world` off the world's origin, or nearer; in the tree's half
    /// sizes.
    ORBWEAVER_INLINE static double slack_of(double away, double world) noexcept {
        return 0x1p-20 + 12 * kGrain * (away + 1 + world);
    }
    /// To the walls of the cube, whose middle is as far along each axis as they are: slack and all.
    ORBWEAVER_INLINE void enter(const Lanes& from, const Lanes& inverses, const Lanes& to_wall,
                                double reach) noexcept {
        const Lanes to_middle = from * inverses;
        const Lanes enters = -to_wall - to_middle, leaves = to_wall - to_middle;
        start = std::max({0.0, enters[0], enters[1], enters[2]});
        meets = start <= std::min({reach, leaves[0], leaves[1], leaves[2]});
    }
};

}  // namespace orbweaver::surface
