#pragma once

#include <span>

#include "ready_parts.hpp"
#include "walker.hpp"

namespace orbweaver::surface {

/// See Surface::stride. `shells` is how many shells the mesh has: with one there is nothing else to run into,
/// and the tree is asked for only at a border, to find what lies right beyond it.
SurfaceStride stride(const mesh::SurfaceMesh& mesh, std::uint32_t shells, const ReadyParts& parts,
                     const Footing& from, double length, std::span<StrideCorner> corners) noexcept;

}  // namespace orbweaver::surface
