#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "grips.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "ready_parts.hpp"
#include "surface_mesh.hpp"

namespace orbweaver::surface {

/// The contract over a mesh. What is dear is made when it is first asked for.
class MeshSurface final : public Surface {
public:
    /// Reads `mesh` and `baked` for as long as it lives.
    MeshSurface(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& baked, GripOverrides grips);

    std::span<const Vec3> vertices() const noexcept override { return mesh_.vertices; }
    std::span<const std::array<std::uint32_t, 3>> faces() const noexcept override { return mesh_.triangles; }
    std::span<const std::uint32_t> polygons() const noexcept override { return mesh_.polygon; }
    double size() const noexcept override { return size_; }
    SurfaceGrip grip(std::uint32_t face) const noexcept override;
    Vec3 position(const SurfacePoint& at) const noexcept override;
    Vec3 normal(std::uint32_t face) const noexcept override;
    SurfaceHit first_hit(const SurfaceRay& ray) const noexcept override;
    SurfaceHit closest_point(const Vec3& point, double reach) const noexcept override;
    Underfoot underfoot(const Stance& stance) const noexcept override;
    SurfaceStep place(const SurfacePoint& at, const Vec3& up, const Vec3& forward) const noexcept override;
    SurfaceStep step(const Footing& from, double length) const noexcept override;
    SurfaceStride stride(const Footing& from, double length,
                         std::span<StrideCorner> corners) const noexcept override;

    /// Whether some query had no memory for what it needed.
    bool out_of_memory() const noexcept { return out_of_memory_.load(std::memory_order_relaxed); }
    const ReadyParts& parts() const noexcept { return parts_; }
    /// Of so few triangles that each is asked in turn: there is no tree over them.
    bool is_treeless() const noexcept { return treeless_; }

private:
    Underfoot underfoot_few(Stance stance) const noexcept;

    template <class Result>
    Result noted(const Result& result, Answer answer) const noexcept {
        if (answer == Answer::failed) out_of_memory_.store(true, std::memory_order_relaxed);
        return result;
    }

    mesh::SurfaceMesh mesh_;
    GripOverrides grips_;
    double size_;
    std::uint32_t shells_;
    bool treeless_;
    ReadyParts parts_;
    mutable std::atomic<bool> out_of_memory_ = false;
};

}  // namespace orbweaver::surface
