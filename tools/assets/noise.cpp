#include "noise.hpp"

#include <cmath>

namespace orbweaver {
namespace {

double fade(double t) { return t * t * t * (t * (6 * t - 15) + 10); }

}  // namespace

double Noise::corner(std::int64_t x, std::int64_t y, std::int64_t z) const noexcept {
    // SplitMix64's finalizer over the three coordinates.
    auto h = seed_ + 0x9e3779b97f4a7c15U * static_cast<std::uint64_t>(x) +
             0xc2b2ae3d27d4eb4fU * static_cast<std::uint64_t>(y) +
             0x165667b19e3779f9U * static_cast<std::uint64_t>(z);
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9U;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebU;
    return static_cast<double>((h ^ (h >> 31)) >> 11) * 0x1p-53;
}

double Noise::value(const Vec3& p) const noexcept {
    const Vec3 cell{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const auto x = static_cast<std::int64_t>(cell.x);
    const auto y = static_cast<std::int64_t>(cell.y);
    const auto z = static_cast<std::int64_t>(cell.z);
    const double u = fade(p.x - cell.x);
    const double v = fade(p.y - cell.y);
    const double w = fade(p.z - cell.z);
    const auto row = [&](std::int64_t dy, std::int64_t dz) {
        return std::lerp(corner(x, y + dy, z + dz), corner(x + 1, y + dy, z + dz), u);
    };
    return std::lerp(std::lerp(row(0, 0), row(1, 0), v), std::lerp(row(0, 1), row(1, 1), v), w);
}

double Noise::fractal(const Vec3& p, int octaves) const noexcept {
    double sum = 0;
    double weight = 0;
    double scale = 1;
    for (int i = 0; i < octaves; ++i, scale *= 2) {
        sum += value(p * scale + Vec3{17.3, 5.1, 9.7} * i) / scale;
        weight += 1 / scale;
    }
    return sum / weight;
}

}  // namespace orbweaver
