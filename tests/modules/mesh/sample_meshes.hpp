#pragma once

#include "build.hpp"
#include "shapes.hpp"

namespace orbweaver::test {

/// A mesh over points by number: the material is called "plain".
inline mesh::RawMesh raw_mesh(std::vector<Vec3> points,
                              std::initializer_list<std::initializer_list<std::uint32_t>> polygons) {
    mesh::RawMesh raw;
    raw.points = std::move(points);
    raw.material_names = {"plain"};
    for (const auto& polygon : polygons) raw.add_polygon(polygon);
    return raw;
}

inline mesh::SurfaceMeshData build(const mesh::RawMesh& raw, mesh::Validation& validation) {
    return mesh::build_surface_mesh(raw, {}, "sample", validation);
}
inline mesh::SurfaceMeshData build(const mesh::RawMesh& raw) {
    mesh::Validation ignored;
    return build(raw, ignored);
}

inline mesh::Validation validation_of(const mesh::RawMesh& raw) {
    mesh::Validation validation;
    build(raw, validation);
    return validation;
}

/// A surface cut out of paper: four points in a square, y = 0.
inline const std::vector<Vec3> kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

}  // namespace orbweaver::test
