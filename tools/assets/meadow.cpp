#include "meadow.hpp"

#include <cmath>
#include <numbers>

namespace orbweaver {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kSunAzimuth = -25;  // degrees
constexpr double kSunElevation = 19;

constexpr Light kZenith = {0.050, 0.140, 0.340};
constexpr Light kMidSky = {0.300, 0.450, 0.600};
constexpr Light kHorizonSky = {0.980, 0.560, 0.270};
constexpr Light kSun = {1.700, 0.880, 0.230};
constexpr Light kCloud = {0.900, 0.830, 0.740};
constexpr Light kFarHill = {0.230, 0.270, 0.290};
constexpr Light kNearHill = {0.085, 0.135, 0.095};
constexpr Light kTreeShade = {0.006, 0.020, 0.016};
constexpr Light kTreeLeaf = {0.040, 0.085, 0.024};
constexpr Light kGrassFar = {0.105, 0.155, 0.030};
constexpr Light kGrassNear = {0.026, 0.066, 0.012};
constexpr Light kGrassFoot = {0.007, 0.018, 0.006};

}  // namespace

Sight sight(double azimuth, double elevation) {
    const double a = azimuth * kRadians;
    const double e = elevation * kRadians;
    return {azimuth, elevation, {std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a)}};
}

double Meadow::glow(const Sight& s) {
    static const Vec3 kSunDirection = sight(kSunAzimuth, kSunElevation).direction;
    const double degrees = std::acos(std::clamp(dot(s.direction, kSunDirection), -1.0, 1.0)) / kRadians;
    return 0.62 * std::exp(-degrees / 6) + 0.38 * std::exp(-degrees / 24);
}

Light Meadow::sky(const Sight& s) const {
    const Light low = mix(kHorizonSky, kMidSky, smooth_step(-2, 26, s.elevation));
    const Light clear = mix(low, kZenith, smooth_step(15, 85, s.elevation)) + kSun * glow(s);
    const Vec3 flat = {3.2 * s.direction.x, 8 * s.direction.y, 3.2 * s.direction.z};
    const double cover = smooth_step(0.48, 0.78, noise_.fractal(flat, 5)) * smooth_step(2, 14, s.elevation);
    return mix(clear, kCloud + kSun * (0.5 * glow(s)), 0.8 * cover);
}

double Meadow::ridge(const Sight& s, double low, double high, double detail, double shift) const {
    // On a cylinder about the viewer, so that the line closes behind his back.
    const Vec3 around = sight(s.azimuth, 0).direction * detail + Vec3{0, shift, 0};
    return std::lerp(low, high, smooth_step(0.2, 0.8, noise_.fractal(around, 4)));
}

Light Meadow::trees(const Sight& s) const {
    const double crowns = noise_.fractal(s.direction * 9.0, 3);
    const double leaves = noise_.fractal(s.direction * 26.0 + Vec3{3, 0, 0}, 2);
    const double lit = smooth_step(0.35, 0.75, 0.6 * crowns + 0.4 * leaves);
    const Light foliage = mix(kTreeShade, kTreeLeaf, lit);
    return foliage + kSun * (glow(s) * (0.06 + 0.20 * lit));
}

Light Meadow::grass(const Sight& s) const {
    const double depth = -s.elevation;
    const Light far_to_near = mix(kGrassFar, kGrassNear, smooth_step(0, 22, depth));
    const Light ground = mix(far_to_near, kGrassFoot, smooth_step(15, 70, depth));
    const Vec3 column = sight(s.azimuth, 0).direction;
    const double coarse = noise_.fractal(column * 7.0 + Vec3{0, 0.09 * depth, 0}, 3);
    const double blades = noise_.fractal(column * 30.0 + Vec3{0, 0.10 * depth + 40, 0}, 2);
    const double shade = 0.45 + 0.75 * coarse + 0.45 * (blades - 0.5) * smooth_step(4, 20, depth);
    return ground * shade + kSun * (0.22 * glow(s) * (0.4 + coarse));
}

Light Meadow::light(const Sight& s) const {
    const double e = s.elevation;
    const double haze = glow(s);
    const double far_line = ridge(s, 3, 11, 1.6, 0);
    const double near_line = ridge(s, 2, 9, 3.0, 20);
    const double clearing = 13 * std::exp(-std::pow((s.azimuth + 27) / 17, 2));  // where the sun looks in
    const double tree_line = ridge(s, 8, 24, 4.5, 40) - clearing;
    const double ground_line = ridge(s, -2.5, 0.5, 2.5, 60);

    // From front to back, and no further than can be seen.
    const double ground = smooth_step(1.8, -1.8, e - ground_line);
    if (ground >= 1) return grass(s);
    const double wood = smooth_step(2.6, -2.2, e - tree_line);
    Light behind{};
    if (wood < 1) {
        const Light far_hill = kFarHill + kSun * (0.55 * haze);
        const Light near_hill = kNearHill + kSun * (0.40 * haze);
        behind = mix(sky(s), far_hill, smooth_step(1.0, -1.0, e - far_line));
        behind = mix(behind, near_hill, smooth_step(1.2, -1.2, e - near_line));
    }
    const Light standing = wood > 0 ? mix(behind, trees(s), wood) : behind;
    return ground > 0 ? mix(standing, grass(s), ground) : standing;
}

}  // namespace orbweaver
