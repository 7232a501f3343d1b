#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "geodesic.hpp"
#include "obj_mesh.hpp"
#include "orbweaver/random.hpp"
#include "ready_parts.hpp"

namespace orbweaver::surface::test {

/// What a creature asks on its way over a mesh: one walk of ten thousand steps, and rays across the mesh.
struct WalkSamples {
    mesh::SurfaceMeshData data;
    mesh::SurfaceMesh mesh;
    TriangleSet set;
    ReadyParts parts;
    double size = 0;         ///< m, of the mesh
    double height = 0;       ///< m, of the body above the surface
    double step_length = 0;  ///< m
    std::vector<Footing> footings;
    std::vector<Stance> stances;
    std::vector<SurfaceRay> short_rays;  ///< from the body down, no farther than a little below its feet
    std::vector<SurfaceRay> long_rays;   ///< from outside through the middle parts of the mesh

    explicit WalkSamples(const std::string& path)
        : data(built(read_obj(path))), mesh(data.view()), set(triangles_of(mesh)), parts(mesh) {
        const Vec3 extent = mesh.bounds.max - mesh.bounds.min;
        size = std::max({extent.x, extent.y, extent.z});
        height = 0.01 * size;
        step_length = 1e-3 * size;
        walk();
        shoot(0.5 * (mesh.bounds.min + mesh.bounds.max));
    }

private:
    void walk() {
        const RandomStream random(1, "walk");
        Footing at =
            place(mesh, {0, {0.4, 0.3, 0.3}}, face_normal(set, 0), mesh.corner(0, 1) - mesh.corner(0, 0)).end;
        std::uint32_t last = 0;
        for (std::uint64_t i = 0; i < 10'000; ++i) {
            const Vec3 aside = random.uniform(i, -0.3, 0.3) * cross(at.up, at.forward);
            at = step(mesh, place(mesh, at.at, at.up, at.forward + aside).end, step_length).end;
            const Stance stance{at.position + height * at.up, at.up, at.forward, last, at.side, 1.5 * height};
            last = at.at.face;
            footings.push_back(at);
            stances.push_back(stance);
            short_rays.push_back({stance.position, -stance.up, stance.reach});
        }
    }

    void shoot(const Vec3& middle) {
        const RandomStream random(1, "rays");
        for (std::uint64_t i = 0; i < 10'000; ++i) {
            const auto in_box = [&](std::uint64_t n) {
                return Vec3{random.uniform(n, -1, 1), random.uniform(n + 1, -1, 1),
                            random.uniform(n + 2, -1, 1)};
            };
            const Vec3 from = middle + size * unit(in_box(6 * i)), to = middle + 0.3 * size * in_box(6 * i + 3);
            long_rays.push_back({from, unit(to - from)});
        }
    }
};

}  // namespace orbweaver::surface::test
