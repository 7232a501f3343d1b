#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "box_ray.hpp"
#include "floats.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

namespace {

/// A child and where the ray enters it, at 0 or beyond: such numbers are in the order of their bits, so that
/// one comparison without a branch orders two.
class Pending {
public:
    Pending() = default;
    ORBWEAVER_INLINE Pending(std::uint32_t child, float enter) noexcept
        : bits_(std::uint64_t{std::bit_cast<std::uint32_t>(enter)} << 32 | child) {}

    ORBWEAVER_INLINE std::uint32_t child() const noexcept { return static_cast<std::uint32_t>(bits_); }
    ORBWEAVER_INLINE float enter() const noexcept {
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits_ >> 32));
    }
    friend ORBWEAVER_INLINE bool operator<(const Pending& a, const Pending& b) noexcept {
        return a.bits_ < b.bits_;
    }

private:
    std::uint64_t bits_;
};

/// `Wide` is FourWide or EightWide: what else is met in fewer or more boxes at once changes nothing of the
/// answer.
template <class Wide>
class Traversal {
    using Floats = typename Wide::Floats;

public:
    ORBWEAVER_INLINE Traversal(const WideTree& tree, const TriangleSet& set, const BoxRay& box,
                               const WatertightRay<Wide>& ray, double reach) noexcept
        : nearest_(reach), tree_(tree), set_(set), box_(box), ray_(ray), reach_(box.in_tree(reach)) {
        for (std::size_t i = 0; i < 3; ++i) {
            Wide::fill(inverse_[i], box.inverse[i]);
            Wide::fill(near_[i], box.near[i]);
            Wide::fill(far_[i], box.far[i]);
        }
    }

    ORBWEAVER_INLINE SurfaceHit run() noexcept {
        std::uint32_t child = 0;
        do {
            while (!is_leaf(child))
                if (!descend(child)) return nearest_.hit();
            try_leaf(child);
        } while (pop(child));
        return nearest_.hit();
    }

private:
    ORBWEAVER_INLINE void try_leaf(std::uint32_t child) noexcept {
        const std::size_t first = leaf_first(child), count = leaf_count(child);
        const double* corners = &tree_.corners[9 * first];
        __builtin_prefetch(&tree_.triangles[first]);  // asked for after the corners
        const auto many = ray_.meet_many([&](std::size_t axis, std::size_t corner) {
            return load(corners + 3 * count * axis + count * corner);
        });
        for (unsigned near = many.near & ((1U << count) - 1); near != 0; near &= near - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(near));
            const WideTriangle& each = tree_.triangles[first + i];
            if ((many.beside >> i & 1U) != 0) [[unlikely]]
                nearest_.try_face(ray_, FarCorners(set_.vertices.data(), each.corners), each.face);
            else
                nearest_.try_crossing(Lanes{many.edges[0][i], many.edges[1][i], many.edges[2][i], 0},
                                      {many.scale[i], many.distance[i]}, each.face);
        }
        if (nearest_.crosses()) reach_ = box_.in_tree(nearest_.reach());
    }

    ORBWEAVER_INLINE bool pop(std::uint32_t& child) noexcept {
        while (count_ > 0) {
            const Pending& next = stack_[--count_];
            child = next.child();
            if (next.enter() <= reach_) return true;
        }
        return false;
    }

    /// From a node to the nearest of its children that the ray meets, the others put by, the farthest first; or
    /// to what was put by before. False when there is nothing more.
    ORBWEAVER_INLINE bool descend(std::uint32_t& child) noexcept {
        const WideNode& node = tree_.nodes[child];
        __builtin_prefetch(&node.children);  // asked for after the boxes
        std::array<float, kWide> enters;
        unsigned met = meet(node, enters);
        if (met == 0) return pop(child);
        const auto first = static_cast<std::size_t>(std::countr_zero(met));
        met &= met - 1;
        if (met == 0) {
            child = node.children[first];
            return true;
        }
        Pending nearest(node.children[first], enters[first]);
        const int bottom = count_;
        for (; met != 0; met &= met - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(met));
            const Pending other(node.children[i], enters[i]);
            const Pending farther = std::max(nearest, other);
            nearest = std::min(nearest, other);
            int at = count_++;
            for (; at > bottom && stack_[at - 1] < farther; --at) stack_[at] = stack_[at - 1];
            stack_[at] = farther;
        }
        child = nearest.child();
        return true;
    }

    /// Which children the ray meets, and where it enters them.
    ORBWEAVER_INLINE unsigned meet(const WideNode& node, std::array<float, kWide>& enters) const noexcept {
        constexpr std::size_t kLanes = sizeof(Floats) / sizeof(float);
        unsigned met = 0;
        Floats reach;
        Wide::fill(reach, reach_);
        for (std::size_t lane = 0; lane < kWide; lane += kLanes) {
            Floats first[3], last[3];
            for (std::size_t i = 0; i < 3; ++i) {
                Wide::scale(floats_at<Floats>(&node.planes[box_.near_plane[i]][lane]), inverse_[i], near_[i],
                            first[i]);
                Wide::scale(floats_at<Floats>(&node.planes[box_.far_plane[i]][lane]), inverse_[i], far_[i],
                            last[i]);
            }
            const Floats enter = larger(larger(first[0], first[1]), larger(first[2], Floats{}));
            const Floats leave = smaller(smaller(last[0], last[1]), smaller(last[2], reach));
            std::memcpy(&enters[lane], &enter, sizeof enter);
            met |= Wide::bits(enter <= leave) << lane;
        }
        return met;
    }

    NearestCrossing nearest_;
    Floats inverse_[3], near_[3], far_[3];
    const WideTree& tree_;
    const TriangleSet& set_;
    const BoxRay& box_;
    const WatertightRay<Wide>& ray_;
    float reach_;
    int count_ = 0;
    Pending stack_[kWideStack];
};

template <class Wide>
ORBWEAVER_INLINE SurfaceHit cast(const WideTree& tree, const TriangleSet& set, const SurfaceRay& ray) noexcept {
    if (!is_sound(ray)) return kRefusedHit;
    if (tree.nodes.empty()) return {};
    const BoxRay box(Wide{}, tree.frame, ray);
    if (!box.meets) return {};
    const WatertightRay<Wide> tight(ray);
    return Traversal<Wide>(tree, set, box, tight, ray.reach).run();
}

ORBWEAVER_AVX2_FMA SurfaceHit cast_avx2(const WideTree& tree, const TriangleSet& set,
                                        const SurfaceRay& ray) noexcept {
    return cast<EightWide>(tree, set, ray);
}

const bool kWideVectors = has_avx2_and_fma();

}  // namespace

SurfaceHit first_hit(const WideTree& tree, const TriangleSet& set, const SurfaceRay& ray) noexcept {
    return kWideVectors ? cast_avx2(tree, set, ray) : cast<FourWide>(tree, set, ray);
}

}  // namespace orbweaver::surface
