#include "skin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "orbweaver/random.hpp"

namespace orbweaver::crawler {

namespace {

constexpr std::uint32_t kTips = 3;           ///< rings in one point, where a spline ends in it
constexpr std::uint32_t kRowsASegment = 24;  ///< texels
constexpr std::uint32_t kMostRows = 2048;

/// Control points are so much farther out than masses that the spline through them lies on the ground.
constexpr double kOut = 48.0 / 44;
/// Corners in the order of Patches.
constexpr std::array<std::uint32_t, kCorners> kOrder{1, 0, 3, 2};

/// A place on a skin.
struct Spot {
    double along = 0;   ///< 0 at the tail, 1 at the head
    double around = 0;  ///< turns from the middle of the back, -0.5 to 0.5
    const RandomStream& random;
};

struct Shade {
    Vec3 color;         ///< sRGB
    double height = 0;  ///< 0 to 1
};

double smooth(double low, double high, double x) noexcept {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}
Vec3 mix(const Vec3& a, const Vec3& b, double share) noexcept { return a + share * (b - a); }

/// Smooth noise of period `period` in x, from 0 to 1.
double noise(const RandomStream& random, double x, double y, std::uint64_t period) noexcept {
    const double fx = std::floor(x), fy = std::floor(y);
    const auto at = [&](double i, double j) {
        const auto column = static_cast<std::uint64_t>(i) % period, row = static_cast<std::uint64_t>(j);
        return random.uniform(row * period + column);
    };
    const double u = smooth(0, 1, x - fx), v = smooth(0, 1, y - fy);
    return std::lerp(std::lerp(at(fx, fy), at(fx + 1, fy), u), std::lerp(at(fx, fy + 1), at(fx + 1, fy + 1), u),
                     v);
}

/// Scales in rows that are staggered, each a dome with a keel; wide plates across the belly.
Shade snake_shade(const Spot& spot) noexcept {
    constexpr double kScalesAround = 26, kScalesAlong = 110, kSaddles = 15;
    const double belly = smooth(0.34, 0.38, std::abs(spot.around));
    const double row = spot.along * kScalesAlong, column = (spot.around + 0.5) * kScalesAround;
    const double shift = std::fmod(std::floor(row), 2) * 0.5;
    const double x = 2 * (column + shift - std::floor(column + shift)) - 1, y = 2 * (row - std::floor(row)) - 1;
    const double dome = std::max(0.0, 1 - x * x - 0.6 * y * y) + 0.25 * std::max(0.0, 1 - 8 * std::abs(x));
    const double plate = 0.8 - 0.8 * smooth(0.6, 1, std::abs(y));
    const double saddle = smooth(0.15, 0.55,
                                 std::cos(2 * std::numbers::pi * kSaddles * spot.along) -
                                     6 * std::abs(spot.around) + 0.4 * noise(spot.random, column, row / 3, 26));
    Vec3 back = mix({0.56, 0.47, 0.30}, {0.22, 0.15, 0.09}, saddle);
    back = mix(back, {0.70, 0.62, 0.42}, 0.35 * smooth(0.16, 0.3, std::abs(spot.around)));
    back = (0.72 + 0.38 * std::min(1.0, dome)) * back;
    return {mix(back, (0.85 + 0.15 * plate) * Vec3{0.84, 0.79, 0.62}, belly), std::lerp(dome, plate, belly)};
}

/// Rings, wrinkled; a saddle near the head.
Shade worm_shade(const Spot& spot) noexcept {
    constexpr double kRings = 90;
    const double saddle = smooth(0.70, 0.72, spot.along) * (1 - smooth(0.79, 0.81, spot.along));
    const double ring = 0.5 + 0.5 * std::cos(2 * std::numbers::pi * kRings * spot.along);
    const double wrinkle = noise(spot.random, (spot.around + 0.5) * 40, spot.along * 400, 40);
    Vec3 skin = mix({0.46, 0.22, 0.20}, {0.72, 0.48, 0.42}, smooth(0.1, 0.45, std::abs(spot.around)));
    skin = mix(skin, {0.74, 0.50, 0.38}, saddle);
    const double height = (1 - 0.6 * saddle) * (1 - std::pow(1 - ring, 3)) * 0.8 + 0.2 * wrinkle;
    return {(0.7 + 0.3 * height) * skin, height};
}

/// Folds between segments; a pale line along each side, and dark spots above it.
Shade caterpillar_shade(const Spot& spot) noexcept {
    constexpr double kSegments = 13;
    const double within = spot.along * kSegments - std::floor(spot.along * kSegments);
    const double fold = std::pow(std::abs(std::cos(std::numbers::pi * within)), 6);
    const double side = std::abs(spot.around);
    const double line = smooth(0.2, 0.22, side) * (1 - smooth(0.26, 0.28, side));
    const double spots = 1 - smooth(0.03, 0.045, std::hypot(side - 0.13, (within - 0.5) * 0.25));
    const double head = smooth(0.965, 0.975, spot.along);
    const double fine = noise(spot.random, (spot.around + 0.5) * 60, spot.along * 260, 60);
    Vec3 skin = mix({0.36, 0.58, 0.16}, {0.55, 0.70, 0.30}, smooth(0.28, 0.45, side));
    skin = mix(skin, {0.92, 0.90, 0.55}, line);
    skin = mix(skin, {0.10, 0.08, 0.06}, spots);
    skin = mix(skin, {0.25, 0.12, 0.06}, head);
    return {(1 - 0.45 * fold) * (0.85 + 0.15 * fine) * skin, (1 - fold) * 0.85 + 0.15 * fine};
}

/// What kinds look like: a shade for each spot, how thick the body is along itself, relief in widths, and
/// gloss.
struct Look {
    std::string_view kind;
    Shade (*shade)(const Spot&) noexcept;
    double (*thickness)(double along) noexcept;
    double relief = 0;
    double gloss = 0;
};

double snake_thickness(double s) noexcept {
    return 0.22 + 0.78 * smooth(0, 0.35, s) - 0.32 * smooth(0.82, 0.92, s) + 0.22 * smooth(0.92, 0.97, s) -
           0.25 * smooth(0.97, 1, s);
}
double worm_thickness(double s) noexcept {
    const double saddle = smooth(0.69, 0.72, s) * (1 - smooth(0.79, 0.82, s));
    return 0.5 + 0.42 * smooth(0, 0.2, s) - 0.3 * smooth(0.85, 1, s) + 0.08 * saddle;
}
double caterpillar_thickness(double s) noexcept {
    return 0.75 + 0.25 * smooth(0, 0.15, s) - 0.2 * smooth(0.88, 1, s);
}

constexpr std::array<Look, 3> kLooks{{{"worm", worm_shade, worm_thickness, 0.05, 0.75},
                                      {"snake", snake_shade, snake_thickness, 0.04, 0.55},
                                      {"caterpillar", caterpillar_shade, caterpillar_thickness, 0.10, 0.3}}};

const Look& look_of(std::string_view kind) noexcept {
    const auto found =
        std::find_if(kLooks.begin(), kLooks.end(), [&](const Look& l) { return l.kind == kind; });
    return found == kLooks.end() ? kLooks.front() : *found;
}

std::uint8_t byte_of(double share) noexcept {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

PatchLayout skin_layout(const Lattice& lattice) noexcept {
    return {lattice.bodies, lattice.rings() + 2 * kTips, kCorners};
}

Skin::Skin(std::string_view kind, const Lattice& lattice, const Build& build)
    : lattice_(lattice), rows_(std::min(kMostRows, kRowsASegment * lattice.segments)) {
    const Look& look = look_of(kind);
    relief_ = look.relief * build.width;
    gloss_ = look.gloss;
    for (std::uint32_t ring = 0; ring < lattice.rings(); ++ring)
        thickness_.push_back(look.thickness(static_cast<double>(ring) / lattice.segments));
    const RandomStream random(0, "skin");
    texels_.reserve(std::size_t{4} * kColumns * rows_);
    for (std::uint32_t row = 0; row < rows_; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            // The belly's middle lies an eighth of a turn after the first point.
            const double turns = (column + 0.5) / kColumns - 0.625;
            const Shade shade = look.shade({(row + 0.5) / rows_, turns < -0.5 ? turns + 1 : turns, random});
            for (const double each : {shade.color.x, shade.color.y, shade.color.z, shade.height})
                texels_.push_back(byte_of(each));
        }
}

std::span<const Vec3> Skin::points(std::span<const Vec3> masses) {
    points_.clear();
    for (std::uint32_t body = 0; body < lattice_.bodies; ++body)
        add_body(masses.subspan(lattice_.point(body, 0), lattice_.points_a_body()));
    return points_;
}

void Skin::add_body(std::span<const Vec3> masses) {
    const auto corners = [&](std::uint32_t ring) { return &masses[std::size_t{kCorners} * ring]; };
    const std::uint32_t last = lattice_.segments;
    const auto add_tips = [&](std::uint32_t end, std::uint32_t before) {
        const Vec3 middle = ring_middle(corners(end)), way = middle - ring_middle(corners(before));
        for (std::uint32_t i = 0; i < kTips; ++i)
            add_ring(middle + 0.5 * way, corners(end), thickness_[end], 0);
    };
    add_tips(0, 1);
    for (std::uint32_t ring = 0; ring <= last; ++ring)
        add_ring(ring_middle(corners(ring)), corners(ring), thickness_[ring], kOut);
    add_tips(last, last - 1);
}

// What is thinner than the lattice lies on the ground as well.
void Skin::add_ring(const Vec3& middle, const Vec3* corners, double thickness, double out) {
    const Vec3 down = 0.25 * (corners[0] + corners[1] - corners[2] - corners[3]);
    const Vec3 center = middle + (1 - thickness) * down, own = ring_middle(corners);
    for (const std::uint32_t corner : kOrder)
        points_.push_back(center + thickness * out * (corners[corner] - own));
}

std::size_t Skin::memory_bytes() const noexcept {
    return texels_.capacity() + points_.capacity() * sizeof(Vec3) + thickness_.capacity() * sizeof(double);
}

}  // namespace orbweaver::crawler
