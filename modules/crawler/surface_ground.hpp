#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/contracts/workers.hpp"
#include "touch.hpp"

namespace orbweaver::crawler {

/// A surface as the points of bodies meet it: each has the plane of what is nearest to it, or of what it flies
/// towards, as it was when last looked at. A point that moves on over an edge of the surface meanwhile stays on
/// the plane that it was on: look often.
class SurfaceGround {
public:
    /// Friction of a surface that says nothing: coefficients of bodies are those on it.
    static constexpr double kUsualFriction = 0.6;

    /// `near`: m, that a point is looked around for at least. Null workers: one thread.
    SurfaceGround(const Surface& surface, std::size_t points, double near, Workers* workers)
        : surface_(&surface), workers_(workers), near_(near), planes_(points) {}

    /// All points look, at x (m) with v (m/s), as far as they may get in `time` s.
    void look(std::span<const Vec3> x, std::span<const Vec3> v, double time) noexcept;
    /// The same of those that may get to the surface in that time, by what they saw last.
    void look_again(std::span<const Vec3> x, std::span<const Vec3> v, double time) noexcept;
    /// What they see now is what rewind() brings back; before the first one it brings back nothing.
    void mark() { marked_ = planes_; }
    void rewind() noexcept { std::copy(marked_.begin(), marked_.end(), planes_.begin()); }
    Touch touch(const Vec3& p, std::size_t point) const noexcept {
        const Plane& plane = planes_[point];
        return {dot(plane.at - p, plane.normal) - plane.clear, plane.normal, plane.grip};
    }
    std::size_t memory_bytes() const noexcept {
        return (planes_.capacity() + marked_.capacity()) * sizeof(Plane);
    }

private:
    struct Plane {
        Vec3 at;           ///< m
        Vec3 normal;       ///< unit
        double clear = 0;  ///< m, infinite where there is nothing to meet
        double grip = 1;
    };

    template <class Wants>
    void look_where(const Wants& wants, std::span<const Vec3> x, std::span<const Vec3> v, double time) noexcept;
    Plane plane_for(const Vec3& x, const Vec3& v, double time) const noexcept;
    Plane plane_at(const SurfacePoint& at, const Vec3& normal) const noexcept;

    const Surface* surface_;
    Workers* workers_;
    double near_;
    std::vector<Plane> planes_, marked_;
};

}  // namespace orbweaver::crawler
