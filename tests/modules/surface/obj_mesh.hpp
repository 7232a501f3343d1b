#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "build.hpp"

namespace orbweaver::surface::test {

inline mesh::SurfaceMeshData built(const mesh::RawMesh& raw) {
    mesh::Validation validation;
    return mesh::build_surface_mesh(raw, {}, "the test's mesh", validation);
}

/// Points and polygons of an OBJ file; everything else in it is passed over.
inline mesh::RawMesh read_obj(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + " is missing");
    mesh::RawMesh raw;
    raw.material_names = {"obj"};
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string kind;
        words >> kind;
        if (kind == "v") {
            Vec3 p;
            words >> p.x >> p.y >> p.z;
            raw.points.push_back(p);
        } else if (kind == "f") {
            for (std::string corner; words >> corner;)
                raw.corners.push_back(static_cast<std::uint32_t>(std::stoul(corner) - 1));
            raw.first.push_back(static_cast<std::uint32_t>(raw.corners.size()));
            raw.material.push_back(0);
        }
    }
    return raw;
}

}  // namespace orbweaver::surface::test
