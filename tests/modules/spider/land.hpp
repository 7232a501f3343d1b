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

/// Both as one mesh, shells of their own.
inline orbweaver::mesh::RawMesh together(orbweaver::mesh::RawMesh a, const orbweaver::mesh::RawMesh& b) {
    const auto points = static_cast<std::uint32_t>(a.points.size());
    const auto corners = static_cast<std::uint32_t>(a.corners.size());
    a.points.insert(a.points.end(), b.points.begin(), b.points.end());
    for (const std::uint32_t each : b.corners) a.corners.push_back(points + each);
    for (std::size_t i = 1; i < b.first.size(); ++i) a.first.push_back(corners + b.first[i]);
    a.material.insert(a.material.end(), b.polygon_count(), 0);
    return a;
}

/// A level floor of 1 m in which a crate of 0.15 m and a smaller one stand, half a finger deep, and a ball.
inline orbweaver::mesh::RawMesh crates_on_a_floor() {
    using namespace orbweaver::mesh;
    RawMesh floor;
    floor.points = {{-0.5, 0, -0.5}, {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, 0, -0.5}};
    floor.material_names = {"floor"};
    floor.add_polygon({0, 1, 2, 3});
    const RawMesh crates = together(transformed(cube(0.15, 2), 1, {0.2, 0.06, 0.1}),
                                    transformed(cube(0.1, 2), 1, {-0.2, 0.03, -0.1}));
    return together(floor, together(crates, transformed(sphere(0.2, 4), 1, {-0.1, 0.05, 0.25})));
}

}  // namespace land
