#include "closest_point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wide_tree.hpp"

namespace orbweaver::surface {

std::array<double, 3> closest_weights(const std::array<Vec3, 3>& p, const Vec3& q) noexcept {
    const Vec3 ab = p[1] - p[0], ac = p[2] - p[0];
    const Vec3 aq = q - p[0], bq = q - p[1], cq = q - p[2];
    const double ab_a = dot(ab, aq), ac_a = dot(ac, aq);
    if (ab_a <= 0 && ac_a <= 0) return {1, 0, 0};
    const double ab_b = dot(ab, bq), ac_b = dot(ac, bq);
    if (ab_b >= 0 && ac_b <= ab_b) return {0, 1, 0};
    const double c = ab_a * ac_b - ab_b * ac_a;
    if (c <= 0 && ab_a >= 0 && ab_b <= 0) {
        const double t = ab_a / (ab_a - ab_b);
        return {1 - t, t, 0};
    }
    const double ab_c = dot(ab, cq), ac_c = dot(ac, cq);
    if (ac_c >= 0 && ab_c <= ac_c) return {0, 0, 1};
    const double b = ab_c * ac_a - ab_a * ac_c;
    if (b <= 0 && ac_a >= 0 && ac_c <= 0) {
        const double t = ac_a / (ac_a - ac_c);
        return {1 - t, 0, t};
    }
    const double a = ab_b * ac_c - ab_c * ac_b;
    if (a <= 0 && ac_b - ab_b >= 0 && ab_c - ac_c >= 0) {
        const double t = (ac_b - ab_b) / ((ac_b - ab_b) + (ab_c - ac_c));
        return {0, 1 - t, t};
    }
    const double total = a + b + c;
    return {a / total, b / total, c / total};
}

namespace {

/// A lower bound of the squared distance from `q` to a child's box, all in the tree's units.
double box_distance2(const WideNode& node, std::size_t child, const double (&q)[3]) noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double below = node.planes[2 * i][child] - q[i];
        const double above = q[i] - node.planes[2 * i + 1][child];
        const double outside = std::max({0.0, below, above});
        sum += outside * outside;
    }
    return sum;
}

class Search {
public:
    Search(const WideTree& tree, const TriangleSet& set, const Vec3& point, double reach) noexcept
        : tree_(tree), set_(set), point_(point), best_(reach) {
        const Vec3 q = (point - tree.frame.middle) / tree.frame.size;
        q_[0] = q.x, q_[1] = q.y, q_[2] = q.z;
        set_bound();
    }

    SurfaceHit run() noexcept {
        open(tree_.nodes[0]);
        while (count_ > 0) {
            const Pending next = stack_[--count_];
            if (next.distance2 > bound2_) continue;
            if (is_leaf(next.child))
                try_leaf(next.child);
            else
                open(tree_.nodes[next.child]);
        }
        return at_.face == kNoFace ? SurfaceHit{} : SurfaceHit{Answer::found, at_, best_};
    }

private:
    struct Pending {
        std::uint32_t child;
        double distance2;
    };

    /// Boxes hold their triangles rounded outwards, by more than the rounding of `q_` unless it is far away.
    void set_bound() noexcept {
        constexpr double kUp = 1 + 0x1p-40;
        const double bound = best_ / tree_.frame.size * kUp +
                             0x1p-48 * (1 + std::abs(q_[0]) + std::abs(q_[1]) + std::abs(q_[2]));
        bound2_ = bound * bound;
    }

    void try_leaf(std::uint32_t child) noexcept {
        const std::uint32_t first = leaf_first(child);
        for (std::uint32_t i = first; i < first + leaf_count(child); ++i) {
            const SurfacePoint at{tree_.triangles[i].face,
                                  closest_weights(set_.corners(tree_.triangles[i].face), point_)};
            const double away = distance(position_of(set_, at), point_);
            if (!(away < best_ || (away == best_ && at.face < at_.face))) continue;
            best_ = away;
            at_ = at;
            set_bound();
        }
    }

    /// Pushes the children within the bound, the nearest last.
    void open(const WideNode& node) noexcept {
        const int bottom = count_;
        for (std::size_t i = 0; i < kWide; ++i) {
            const double distance2 = box_distance2(node, i, q_);
            if (!(distance2 <= bound2_)) continue;
            if (!has_box(node, i)) continue;
            int at = count_++;
            for (; at > bottom && stack_[at - 1].distance2 < distance2; --at) stack_[at] = stack_[at - 1];
            stack_[at] = {node.children[i], distance2};
        }
    }

    const WideTree& tree_;
    const TriangleSet& set_;
    Vec3 point_;
    double q_[3];
    double best_;
    double bound2_ = 0;
    SurfacePoint at_;
    int count_ = 0;
    Pending stack_[kWideStack];
};

}  // namespace

SurfaceHit closest_point(const WideTree& tree, const TriangleSet& set, const Vec3& point,
                         double reach) noexcept {
    if (!is_finite(point) || !(reach >= 0)) return kRefusedHit;
    if (tree.nodes.empty()) return {};
    return Search(tree, set, point, reach).run();
}

}  // namespace orbweaver::surface
