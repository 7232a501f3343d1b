#pragma once

#include <optional>
#include <utility>

#include "build.hpp"
#include "mesh_surface.hpp"
#include "shapes.hpp"

/// A mesh of ours to walk on.
namespace land {

using orbweaver::Vec3;

class Land {
public:
    explicit Land(const orbweaver::mesh::RawMesh& raw, orbweaver::surface::GripOverrides grips = {})
        : mesh_(built(raw)), surface_(mesh_.view(), std::nullopt, std::move(grips)) {}
    const orbweaver::Surface& surface() const { return surface_; }

    /// Somebody on the face nearest to `position`.
    orbweaver::Footing stand(const Vec3& position, const Vec3& up, const Vec3& forward) const {
        const orbweaver::SurfaceHit hit = surface_.closest_point(position, 10);
        return surface_.place(hit.at, up, forward).end;
    }

private:
    static orbweaver::mesh::SurfaceMeshData built(const orbweaver::mesh::RawMesh& raw) {
        orbweaver::mesh::Validation validation;
        return orbweaver::mesh::build_surface_mesh(raw, {}, "the test's mesh", validation);
    }

    orbweaver::mesh::SurfaceMeshData mesh_;
    orbweaver::surface::MeshSurface surface_;
};

}  // namespace land
