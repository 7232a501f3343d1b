#pragma once

#include "mesh_surface.hpp"
#include "orbweaver/contracts/surface_ways.hpp"

namespace orbweaver::surface {

/// The ways in which a mesh can be asked.
class MeshWays final : public SurfaceWays {
public:
    /// Reads `surface` for as long as it lives.
    explicit MeshWays(const MeshSurface& surface) : surface_(surface) {}

    std::span<const Way> ways() const noexcept override;
    void answer(std::size_t way, std::span<const Stance> questions,
                std::span<SurfaceHit> hits) const noexcept override;

private:
    const MeshSurface& surface_;
};

}  // namespace orbweaver::surface
