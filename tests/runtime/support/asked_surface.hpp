#pragma once

#include "build.hpp"
#include "mesh_ways.hpp"
#include "shapes.hpp"

namespace orbweaver::test {

/// A surface to be studied, without a scene or a module.
struct AskedSurface {
    mesh::SurfaceMeshData data;
    surface::MeshSurface surface;
    surface::MeshWays ways{surface};

    explicit AskedSurface(const mesh::RawMesh& raw)
        : data(built(raw)), surface(data.view(), std::nullopt, {}) {}

private:
    static mesh::SurfaceMeshData built(const mesh::RawMesh& raw) {
        mesh::Validation validation;
        return mesh::build_surface_mesh(raw, {}, "the test's mesh", validation);
    }
};

}  // namespace orbweaver::test
