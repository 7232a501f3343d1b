#pragma once

#include <algorithm>
#include <string>

#include "shapes.hpp"
#include "surface/obj_mesh.hpp"

namespace orbweaver {

/// Its middle at the origin, its largest extent as given (m).
inline mesh::RawMesh real_mesh(const std::string& name, double size) {
    const mesh::RawMesh raw = surface::test::read_obj(std::string(ORBWEAVER_MESHES) + "/" + name + ".obj");
    Vec3 low = raw.points[0], high = low;
    for (const Vec3& p : raw.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 extent = high - low;
    const double scale = size / std::max({extent.x, extent.y, extent.z});
    return mesh::transformed(raw, scale, -0.5 * scale * (low + high));
}

}  // namespace orbweaver
