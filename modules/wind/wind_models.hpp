#pragma once

#include "orbweaver/contracts/wind_field.hpp"
#include "orbweaver/random.hpp"

namespace orbweaver::wind {

/// Air at rest.
class CalmWind final : public WindField {
public:
    void sample(const WindQuery& query, std::span<Vec3> velocity,
                std::span<Vec3> force) const noexcept override;
};

/// The same velocity (m/s) everywhere and always.
class SteadyWind final : public WindField {
public:
    explicit SteadyWind(const Vec3& velocity) noexcept : velocity_(velocity) {}
    void sample(const WindQuery& query, std::span<Vec3> velocity,
                std::span<Vec3> force) const noexcept override;

private:
    Vec3 velocity_;
};

/// The generator of the thesis's figure 5.45, which speaks as a force:
///   F(x, t) = exp(d/(50 R)) W sin(degree) (random, random, -1),
/// degree = floor(t degrees_per_second), random anew in [-3, 3) whenever degree is a multiple of 50, d the
/// distance of x from the body's center, R the body's radius, W the strength. A pure function of time: the
/// n-th random number belongs to the n-th 50 degrees.
class ThesisWind final : public WindField {
public:
    ThesisWind(double strength, double degrees_per_second, const RandomStream& stream) noexcept
        : strength_(strength), degrees_per_second_(degrees_per_second), stream_(stream) {}
    void sample(const WindQuery& query, std::span<Vec3> velocity,
                std::span<Vec3> force) const noexcept override;

    /// wind_vector of the figure, N.
    Vec3 wind_vector(double time) const noexcept;

private:
    double strength_;  // N
    double degrees_per_second_;
    RandomStream stream_;
};

}  // namespace orbweaver::wind
