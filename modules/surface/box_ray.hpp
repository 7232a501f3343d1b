#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "floats.hpp"
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
    std::array<std::size_t, 3> near_plane, far_plane;
    FourWide::Floats inverse, near, far;  ///< axis i: a plane p is met at p * inverse[i] - near[i], or far[i]
    double start = 0;                     ///< where it enters
    double per_unit;                      ///< our distances in one length of its direction

    template <class Wide>
    ORBWEAVER_INLINE BoxRay(Wide, const WideFrame& frame, const SurfaceRay& ray) noexcept {
        const double power = power_to_one(ray.direction);
        const double per_size = 1 / frame.size;
        per_unit = per_size * inverse_of_power(power);
        const Lanes origin = lanes_of(ray.origin), middle = lanes_of(frame.middle);
        Lanes powers, per_sizes;
        Wide::fill(powers, power);
        Wide::fill(per_sizes, per_size);
        const Lanes direction = powers * lanes_of(ray.direction);
        const Lanes steep = least(1 / absolute(direction), in_all(kSteepest));
        const Lanes inverses = flipped_by(direction, steep);
        Lanes at = (origin - middle) * per_sizes;
        double slack = slack_of(1, largest(middle) * per_size + 1);
        if (const double away = largest(at); away > 1) {
            slack = slack_of(away, largest(origin) * per_size);
            enter(at, inverses, steep * (1 + 2 * slack), ray.reach * per_unit);
            at += start * direction;
        }
        Lanes slacks;
        Wide::fill(slacks, slack);
        const Lanes outwards = flipped_by(direction, slacks);
        inverse = singles(inverses);
        near = singles(at + outwards) * inverse;
        far = singles(at - outwards) * inverse;
        const unsigned backwards = Wide::signs(direction);
        for (std::size_t i = 0; i < 3; ++i) {
            near_plane[i] = 2 * i + (backwards >> i & 1U);
            far_plane[i] = near_plane[i] ^ 1U;
        }
    }

    /// A distance in lengths of the direction as ours from where it enters, rounded up.
    ORBWEAVER_INLINE float in_tree(double distance) const noexcept {
        constexpr float kUp = 1.000001F;
        return static_cast<float>(distance * per_unit - start) * kUp + 0x1p-20F;
    }

private:
    static constexpr double kSteepest = 0x1p96;  // inverse of a component that is taken for 0: still a single

    ORBWEAVER_INLINE static Lanes lanes_of(const Vec3& v) noexcept { return Lanes{v.x, v.y, v.z, 0}; }
    ORBWEAVER_INLINE static Lanes least(const Lanes& a, const Lanes& b) noexcept { return a < b ? a : b; }
    ORBWEAVER_INLINE static FourWide::Floats singles(const Lanes& of) noexcept {
        return __builtin_convertvector(of, FourWide::Floats);
    }
    ORBWEAVER_INLINE static double largest(const Lanes& of) noexcept {
        const Lanes size = absolute(of);
        return std::max(std::max(size[0], size[1]), size[2]);
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
