#include "surface_ground.hpp"

#include <cmath>
#include <limits>

namespace orbweaver::crawler {

template <class Wants>
void SurfaceGround::look_where(const Wants& wants, std::span<const Vec3> x, std::span<const Vec3> v,
                               double time) noexcept {
    constexpr std::size_t kGrain = 64;
    auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (wants(i)) planes_[i] = plane_for(x[i], v[i], time);
    };
    workers_ != nullptr ? workers_->for_each_range(x.size(), kGrain, range) : range(0, x.size());
}

void SurfaceGround::look(std::span<const Vec3> x, std::span<const Vec3> v, double time) noexcept {
    look_where([](std::size_t) { return true; }, x, v, time);
}

void SurfaceGround::look_again(std::span<const Vec3> x, std::span<const Vec3> v, double time) noexcept {
    // A point that does not fly saw what is nearest: it is no nearer to anything else.
    constexpr double kNear = 0.25, kWays = 2;
    look_where(
        [&](std::size_t i) {
            const double above = -touch(x[i], i).depth, way = time * norm(v[i]);
            return !std::isfinite(above) || way > kNear * near_ || above < kNear * near_ + kWays * way;
        },
        x, v, time);
}

// What is nearest, unless the point flies so fast that it would get past that: then what it flies into.
SurfaceGround::Plane SurfaceGround::plane_for(const Vec3& x, const Vec3& v, double time) const noexcept {
    const double way = norm(v) * time;
    if (way > near_) {
        const SurfaceHit ahead = surface_->first_hit({x, v, 2 * time});
        if (ahead.answer == Answer::found) {
            const Vec3 normal = surface_->normal(ahead.at.face);
            return plane_at(ahead.at, dot(normal, v) > 0 ? -normal : normal);
        }
    }
    const SurfaceHit nearest = surface_->closest_point(x, near_ + way);
    if (nearest.answer != Answer::found) return {{}, {0, 1, 0}, std::numeric_limits<double>::infinity(), 1};
    const Vec3 normal = surface_->normal(nearest.at.face), out = x - surface_->position(nearest.at);
    // In front of an edge or a corner it is that which is to be kept off, not the plane of a face beside it.
    const double far = norm(out);
    const bool beside = far > 1e-3 * near_ && dot(out, normal) > 0;
    return plane_at(nearest.at, beside ? out / far : normal);
}

SurfaceGround::Plane SurfaceGround::plane_at(const SurfacePoint& at, const Vec3& normal) const noexcept {
    return {surface_->position(at), normal, 0, surface_->grip(at.face).friction / kUsualFriction};
}

}  // namespace orbweaver::crawler
