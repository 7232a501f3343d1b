#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "orbweaver/contracts/surface.hpp"
#include "surface_mesh.hpp"

namespace orbweaver::surface {

/// What a scene says of some faces, in place of what was baked.
struct GripOverride {
    std::optional<double> friction;
    std::optional<bool> climbable;
};

/// Polygons from `first` to `last`, which are of one patch.
struct PatchedRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t patch = 0;
};

/// What a scene says of a surface: of all of it, of its materials, and of patches of its polygons. The more
/// particular one counts.
struct GripOverrides {
    GripOverride all;
    std::vector<GripOverride> materials;  ///< one a property of the mesh, or none
    std::vector<GripOverride> patches;
    std::vector<PatchedRange> patched;  ///< ascending, apart from each other

    SurfaceGrip grip(const mesh::SurfaceMesh& mesh, std::uint32_t face) const noexcept;
};

/// "0-11, 15": ranges of polygons, first and last, ascending; what overlaps or adjoins is one. Nothing for a
/// text that is no such list.
using PolygonRange = std::pair<std::uint32_t, std::uint32_t>;
std::optional<std::vector<PolygonRange>> parse_polygons(std::string_view text);

}  // namespace orbweaver::surface
