#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mesh {

/// Polygons over points, as a file or a procedure gives them: nothing welded, nothing checked.
struct RawMesh {
    std::vector<Vec3> points;  ///< m
    std::vector<std::uint32_t>
        corners;  ///< of all polygons in a row, counter-clockwise from outside; indices of points
    std::vector<std::uint32_t> first{0};      ///< polygons + 1: where each polygon's corners begin
    std::vector<std::uint32_t> material;      ///< one a polygon
    std::vector<std::string> material_names;  ///< one a material

    std::size_t polygon_count() const noexcept { return first.size() - 1; }

    void add_polygon(std::initializer_list<std::uint32_t> polygon, std::uint32_t of_material = 0) {
        corners.insert(corners.end(), polygon);
        first.push_back(static_cast<std::uint32_t>(corners.size()));
        material.push_back(of_material);
    }
};

/// Throws Fault(invalid) for the first thing that makes a mesh meaningless: arrays that disagree, a polygon of
/// less than three corners, an index without its point or material, a coordinate that is not finite or farther
/// out than 1e50 m (areas would overflow), nothing at all, or more than 2^29 - 2 triangles. `name` stands for
/// the mesh in the sentence.
void check(const RawMesh& raw, const std::string& name);

}  // namespace orbweaver::mesh
