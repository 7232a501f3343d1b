#pragma once

#include <fcl/geometry/bvh/BVH_model.h>

#include <string>

#include "orbweaver/fault.hpp"
#include "triangle_set.hpp"

namespace orbweaver::surface {

/// Fills an FCL model; throws Fault(internal) when FCL will not have it.
template <class Volume>
void build_model(fcl::BVHModel<Volume>& model, const TriangleSet& set) {
    if (set.triangles.empty()) return;
    std::vector<fcl::Vector3d> points;
    points.reserve(set.vertices.size());
    for (const Vec3& v : set.vertices) points.emplace_back(v.x, v.y, v.z);
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(set.triangles.size());
    for (const Corners& c : set.triangles) triangles.emplace_back(c[0], c[1], c[2]);
    model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size()));
    model.addSubModel(points, triangles);
    const int code = model.endModel();
    if (code != fcl::BVH_OK)
        throw Fault(FaultKind::internal, "FCL could not build its tree over " +
                                             std::to_string(triangles.size()) + " triangles (its code " +
                                             std::to_string(code) + ")");
}

template <class Volume>
std::size_t model_bytes(const fcl::BVHModel<Volume>& model) noexcept {
    return sizeof(fcl::BVNode<Volume>) * static_cast<std::size_t>(model.getNumBVs()) +
           sizeof(fcl::Vector3d) * static_cast<std::size_t>(model.num_vertices) +
           sizeof(fcl::Triangle) * static_cast<std::size_t>(model.num_tris);
}

}  // namespace orbweaver::surface
