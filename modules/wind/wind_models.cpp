#include "wind_models.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/exact_math.hpp"

namespace orbweaver::wind {

namespace {

constexpr double kDegreesPerRandom = 50;
constexpr double kLargestRandom = 3;
constexpr double kRadiiPerAlpha = 50;  // alpha = orb web radius * 50

}  // namespace

void CalmWind::sample(const WindQuery&, std::span<Vec3> velocity, std::span<Vec3> force) const noexcept {
    std::fill(velocity.begin(), velocity.end(), Vec3{});
    std::fill(force.begin(), force.end(), Vec3{});
}

void SteadyWind::sample(const WindQuery&, std::span<Vec3> velocity, std::span<Vec3> force) const noexcept {
    std::fill(velocity.begin(), velocity.end(), velocity_);
    std::fill(force.begin(), force.end(), Vec3{});
}

Vec3 ThesisWind::wind_vector(double time) const noexcept {
    constexpr double kRounding = 1e-6;  // of a degree: time is a product of frame and step
    const double degree = std::floor(time * degrees_per_second_ + kRounding);
    const auto block = static_cast<std::uint64_t>(std::max(0.0, degree / kDegreesPerRandom));
    const double random = stream_.uniform(block, -kLargestRandom, kLargestRandom);
    const double wave = strength_ * sin_degrees(degree);
    return {random * wave, random * wave, -wave};
}

void ThesisWind::sample(const WindQuery& query, std::span<Vec3> velocity,
                        std::span<Vec3> force) const noexcept {
    const Vec3 wind = wind_vector(query.time);
    const double alpha = kRadiiPerAlpha * query.radius;
    for (std::size_t i = 0; i < force.size(); ++i) {
        const double away = alpha > 0 ? distance(query.positions[i], query.center) / alpha : 0;
        velocity[i] = {};
        force[i] = wind * exponential(away);
    }
}

}  // namespace orbweaver::wind
