#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "four.hpp"
#include "watertight.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

namespace {

/// A ray in the tree's coordinates, begun where it enters the cube [-1, 1]: single precision then rounds by no
/// more than 2^-21 of the tree's half size in all (positions up to 1, one subtraction, two products), whatever
/// the distance that the ray comes from. Planes are moved outwards by twice that, and by the rounding of the
/// triangle test, which grows with that distance.
struct BoxRay {
    bool meets = false;
    std::array<std::size_t, 3> near_plane{}, far_plane{};
    std::array<float, 3> inverse{}, near{}, far{};
    double start = 0;  ///< where it enters, in lengths of its direction
    double unit = 1;   ///< the tree's unit of distance in lengths of its direction

    BoxRay(const WideFrame& frame, const SurfaceRay& ray) noexcept {
        const Vec3 from = (ray.origin - frame.middle) / frame.size;
        const double o[3] = {from.x, from.y, from.z};
        const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        const double longest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
        const double away = std::max({std::abs(o[0]), std::abs(o[1]), std::abs(o[2])}) + 1;
        const double world = std::max({std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
        const double slack = 0x1p-20 + 12 * kGrain * (away + world / frame.size);
        unit = frame.size / longest;
        double direction[3], enter = 0, leave = ray.reach / unit;
        for (std::size_t i = 0; i < 3; ++i) {
            constexpr double kFlattest = 0x1p-96;  // of the direction: its inverse is still a single
            direction[i] = d[i] / longest;
            const double slope = std::copysign(std::max(std::abs(direction[i]), kFlattest), direction[i]);
            const double wall = std::copysign(1 + 2 * slack, slope);
            enter = std::max(enter, (-wall - o[i]) / slope);
            leave = std::min(leave, (wall - o[i]) / slope);
            inverse[i] = static_cast<float>(1 / slope);
        }
        meets = enter <= leave;
        start = enter * unit;
        for (std::size_t i = 0; i < 3; ++i) {
            const double at = o[i] + enter * direction[i];
            const double outwards = std::copysign(slack, inverse[i]);
            near_plane[i] = 2 * i + (inverse[i] < 0 ? 1 : 0);
            far_plane[i] = 2 * i + (inverse[i] < 0 ? 0 : 1);
            near[i] = static_cast<float>(at + outwards);
            far[i] = static_cast<float>(at - outwards);
        }
    }

    /// A distance along the ray in the tree's units, rounded up.
    float in_tree(double distance) const noexcept {
        constexpr float kUp = 1.000001F;
        return static_cast<float>((distance - start) / unit) * kUp + 0x1p-20F;
    }
};

struct Pending {
    std::uint32_t child;
    float enter;
};

class Traversal {
public:
    Traversal(const WideTree& tree, const TriangleSet& set, const BoxRay& box, const SurfaceRay& ray) noexcept
        : tree_(tree), set_(set), box_(box), ray_(ray), nearest_(ray.reach), reach_(box.in_tree(ray.reach)) {}

    SurfaceHit run() noexcept {
        open(tree_.nodes[0]);
        while (count_ > 0) {
            const Pending next = stack_[--count_];
            if (next.enter > reach_) continue;
            if ((next.child & kLeafBit) != 0)
                try_leaf(next.child);
            else
                open(tree_.nodes[next.child]);
        }
        return nearest_.hit(set_);
    }

private:
    void try_leaf(std::uint32_t child) noexcept {
        const WideTriangle* each = tree_.triangles.data() + leaf_first(child);
        for (const WideTriangle* end = each + leaf_count(child); each != end; ++each)
            nearest_.try_face(ray_, set_.vertices, each->corners, each->face);
        if (nearest_.crosses()) reach_ = box_.in_tree(nearest_.reach());
    }

    /// Pushes the children that the ray meets, the nearest last.
    void open(const WideNode& node) noexcept {
        Four enter = Four::all(0), leave = Four::all(reach_);
        for (std::size_t i = 0; i < 3; ++i) {
            const Four inverse = Four::all(box_.inverse[i]);
            enter = larger(enter,
                           (Four::load(node.planes[box_.near_plane[i]]) - Four::all(box_.near[i])) * inverse);
            leave =
                smaller(leave, (Four::load(node.planes[box_.far_plane[i]]) - Four::all(box_.far[i])) * inverse);
        }
        alignas(16) std::array<float, kWide> enters;
        enter.store(enters);
        const int bottom = count_;
        for (unsigned met = at_most(enter, leave); met != 0; met &= met - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(met));
            int at = count_++;
            for (; at > bottom && stack_[at - 1].enter < enters[i]; --at) stack_[at] = stack_[at - 1];
            stack_[at] = {node.children[i], enters[i]};
        }
    }

    const WideTree& tree_;
    const TriangleSet& set_;
    const BoxRay& box_;
    WatertightRay ray_;
    NearestCrossing nearest_;
    float reach_;
    int count_ = 0;
    Pending stack_[kWideStack];
};

}  // namespace

SurfaceHit first_hit(const WideTree& tree, const TriangleSet& set, const SurfaceRay& ray) noexcept {
    if (!is_sound(ray)) return kRefusedHit;
    if (tree.nodes.empty()) return {};
    const BoxRay box(tree.frame, ray);
    if (!box.meets) return {};
    return Traversal(tree, set, box, ray).run();
}

}  // namespace orbweaver::surface
