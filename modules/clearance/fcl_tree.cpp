#include "fcl_tree.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fcl_mesh.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

namespace {

using Boxes = fcl::BVHModel<fcl::AABB<double>>;

/// One ray against boxes. A corner of a triangle is moved by the rounding of the triangle test by a few units
/// in the last place of its distance from the ray's origin, so each plane of a box is moved outwards by as much
/// as that can be for the farthest corner there is.
class SlabRay {
public:
    SlabRay(const SurfaceRay& ray, const fcl::AABB<double>& all) noexcept {
        const double o[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
        const double d[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
        double farthest = 0;
        for (int i = 0; i < 3; ++i)
            farthest = std::max(
                {farthest, std::abs(all.min_[i] - o[i]), std::abs(all.max_[i] - o[i]), std::abs(o[i])});
        constexpr double kAxes =
            12;  // a corner's grain is of three distances and three coordinates, here doubled
        const double slack = kAxes * kGrain * farthest;
        for (int i = 0; i < 3; ++i) {
            constexpr double kLargest = 1e200;  // instead of infinity, which 0 times is nothing
            backwards_[i] = std::signbit(d[i]);
            inverse_[i] = std::copysign(std::min(1 / std::abs(d[i]), kLargest), d[i]);
            origin_[i] = o[i];
            slack_[i] = std::copysign(slack, d[i]);
        }
    }

    /// Distance at which the box is entered, or infinity when it is not met within [0, reach].
    double entry(const fcl::AABB<double>& box, double reach) const noexcept {
        double enter = 0;
        double leave = reach;
        for (int i = 0; i < 3; ++i) {
            const double first = backwards_[i] ? box.max_[i] : box.min_[i];
            const double last = backwards_[i] ? box.min_[i] : box.max_[i];
            enter = std::max(enter, (first - origin_[i] - slack_[i]) * inverse_[i]);
            leave = std::min(leave, (last - origin_[i] + slack_[i]) * inverse_[i]);
        }
        return enter <= leave ? enter : std::numeric_limits<double>::infinity();
    }

private:
    bool backwards_[3];
    double inverse_[3], origin_[3], slack_[3];  // far from the world's origin, their sum would round to it
};

struct Traversal {
    const Boxes& boxes;
    const TriangleSet& set;
    SlabRay slabs;
    WatertightRay<> ray;
    NearestCrossing nearest;

    void visit(int index) noexcept {
        const auto& node = boxes.getBV(index);
        if (node.isLeaf()) {
            const auto face = static_cast<std::uint32_t>(node.primitiveId());
            nearest.try_face(ray, FarCorners(set.vertices.data(), set.triangles[face]), face);
            return;
        }
        int first = node.leftChild();
        int second = node.rightChild();
        double first_entry = slabs.entry(boxes.getBV(first).bv, nearest.reach());
        double second_entry = slabs.entry(boxes.getBV(second).bv, nearest.reach());
        if (second_entry < first_entry) {
            std::swap(first, second);
            std::swap(first_entry, second_entry);
        }
        if (std::isfinite(first_entry)) visit(first);
        if (second_entry <= nearest.reach() && std::isfinite(second_entry)) visit(second);
    }
};

}  // namespace

struct FclTree::Model {
    Boxes boxes;
};

FclTree::FclTree(const TriangleSet& set) : set_(set), model_(std::make_unique<Model>()) {
    build_model(model_->boxes, set);
}

FclTree::~FclTree() = default;

SurfaceHit FclTree::first_hit(const SurfaceRay& ray) const noexcept {
    if (!is_sound(ray)) return kRefusedHit;
    if (set_.triangles.empty()) return {};
    const auto& root = model_->boxes.getBV(0).bv;
    Traversal traversal{model_->boxes, set_, SlabRay(ray, root), WatertightRay<>(ray),
                        NearestCrossing(ray.reach)};
    if (std::isfinite(traversal.slabs.entry(root, ray.reach))) traversal.visit(0);
    return traversal.nearest.hit();
}

std::size_t FclTree::memory_bytes() const noexcept { return model_bytes(model_->boxes); }

}  // namespace orbweaver::surface
