#include "raw_mesh.hpp"

#include "orbweaver/fault.hpp"
#include "surface_mesh.hpp"

namespace orbweaver::mesh {

namespace {

constexpr double kFarthest = 1e50;  // m

[[noreturn]] void refuse(const std::string& name, const std::string& what) {
    throw Fault(FaultKind::invalid, name + ": " + what);
}

bool is_near(double x) noexcept { return x >= -kFarthest && x <= kFarthest; }

void check_polygons(const RawMesh& raw, const std::string& name) {
    if (raw.first.empty() || raw.first.front() != 0 || raw.first.back() != raw.corners.size() ||
        raw.material.size() != raw.polygon_count())
        refuse(name, "polygons, corners and materials disagree in number; export the mesh again");
    if (raw.polygon_count() == 0)
        refuse(name, "the mesh has no polygon; expected at least one (points and lines are no surface)");
    for (std::size_t p = 0; p < raw.polygon_count(); ++p) {
        const std::string polygon = "polygon " + std::to_string(p);
        if (raw.first[p + 1] < raw.first[p] || raw.first[p + 1] - raw.first[p] < 3)
            refuse(name, polygon + " has fewer than three corners; export the mesh again");
        if (raw.material[p] >= raw.material_names.size())
            refuse(name, polygon + " has material " + std::to_string(raw.material[p]) + " of " +
                             std::to_string(raw.material_names.size()) + "; export the mesh again");
    }
}

}  // namespace

void check(const RawMesh& raw, const std::string& name) {
    for (std::size_t i = 0; i < raw.points.size(); ++i) {
        const Vec3& p = raw.points[i];
        if (!is_near(p.x) || !is_near(p.y) || !is_near(p.z))
            refuse(name,
                   "point " + std::to_string(i) + " is (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                       ", " + std::to_string(p.z) +
                       "); expected finite coordinates within 1e50 m, so scale it down or export it again");
    }
    check_polygons(raw, name);
    for (std::size_t c = 0; c < raw.corners.size(); ++c)
        if (raw.corners[c] >= raw.points.size())
            refuse(name, "corner " + std::to_string(c) + " is point " + std::to_string(raw.corners[c]) +
                             " of " + std::to_string(raw.points.size()) + "; export the mesh again");
    if (raw.corners.size() - 2 * raw.polygon_count() > kMostTriangles)
        throw Fault(FaultKind::limit, name + ": the mesh has more than 536870910 triangles; simplify it");
}

}  // namespace orbweaver::mesh
