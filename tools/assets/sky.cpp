#include "sky.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include "meadow.hpp"
#include "orbweaver/fault.hpp"
#include "orbweaver/random.hpp"
#include "picture/color.hpp"

namespace orbweaver {
namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 16384;
constexpr double kRadians = std::numbers::pi / 180;

/// A point of light or a flower, spread to a disk by a lens focused elsewhere.
struct Disk {
    Sight center;
    double radius = 1;  ///< degrees
    Light light;
    double opacity = 1;
    double sharpness = 0.8;  ///< of its radius, from which on it fades; smaller is softer
};

/// A blade of grass close before the lens, all angles in degrees.
struct Blade {
    double azimuth = 0;
    double foot = -60;  ///< elevation
    double tip = -10;   ///< elevation
    double lean = 0;    ///< how far the tip hangs over
    double width = 1;   ///< half of it, at the foot
    Light light;
    double opacity = 1;
};

/// A filmic curve for light of a sunny day (Narkowicz 2015), which keeps the shade deep and the sun soft.
float filmic(double light) {
    const double x = 0.70 * light;
    return static_cast<float>(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

/// Light on its way to becoming a picture.
class Canvas {
public:
    explicit Canvas(const SkyRecipe& recipe)
        : width_(recipe.width),
          height_(recipe.height),
          pixels_(static_cast<std::size_t>(recipe.width) * static_cast<std::size_t>(recipe.height)) {}

    void paint(const Meadow& meadow);
    void paint(const Disk& disk);
    void paint(const Blade& blade);
    picture::Picture develop() const;

private:
    struct Span {
        int first = 0;
        int last = 0;
    };
    Span rows_within(double low, double high) const {
        const auto row = [&](double e) { return static_cast<int>((0.5 - e / 180) * height_); };
        return {std::clamp(row(high), 0, height_ - 1), std::clamp(row(low), 0, height_ - 1)};
    }
    Span columns_within(const Sight& center, double degrees) const {
        const double squeeze = std::max(0.05, std::cos((std::abs(center.elevation) + degrees) * kRadians));
        const int half = std::min(width_ / 2 - 1, static_cast<int>(degrees / squeeze / 360 * width_) + 1);
        const int middle = static_cast<int>((center.azimuth / 360 + 0.5) * width_);
        return {middle - half, middle + half};
    }
    double azimuth(int x) const { return ((x + 0.5) / width_ - 0.5) * 360; }
    double elevation(int y) const { return (0.5 - (y + 0.5) / height_) * 180; }
    Light& pixel(int x, int y) {
        const int wrapped = ((x % width_) + width_) % width_;
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(wrapped)];
    }

    int width_;
    int height_;
    std::vector<Light> pixels_;
};

void Canvas::paint(const Meadow& meadow) {
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) pixel(x, y) = meadow.light(sight(azimuth(x), elevation(y)));
}

void Canvas::paint(const Disk& disk) {
    const double reach = 1.15 * disk.radius;
    const Span rows = rows_within(disk.center.elevation - reach, disk.center.elevation + reach);
    const Span columns = columns_within(disk.center, reach);
    for (int y = rows.first; y <= rows.last; ++y) {
        for (int x = columns.first; x <= columns.last; ++x) {
            const Vec3 there = sight(azimuth(x), elevation(y)).direction;
            const double r = distance(there, disk.center.direction) / (disk.radius * kRadians);
            const double rim = 0.72 + 0.28 * smooth_step(0.3, 0.9, r);  // lenses gather light towards the edge
            Light& seen = pixel(x, y);
            seen = mix(seen, disk.light, disk.opacity * rim * smooth_step(1.12, disk.sharpness, r));
        }
    }
}

void Canvas::paint(const Blade& blade) {
    const double height = blade.tip - blade.foot;
    const double sway = std::abs(blade.lean) + 2 * blade.width;
    const Span rows = rows_within(blade.foot, blade.tip);
    const Span columns = columns_within(sight(blade.azimuth, blade.foot), sway);
    for (int y = rows.first; y <= rows.last; ++y) {
        const double t = (elevation(y) - blade.foot) / height;
        const double middle = blade.azimuth + blade.lean * t * t;
        const double half = blade.width * (1 - 0.75 * t);
        const double cover = blade.opacity * smooth_step(0, 0.25, t) * smooth_step(1, 0.7, t);
        for (int x = columns.first; x <= columns.last; ++x) {
            Light& seen = pixel(x, y);
            seen = mix(seen, blade.light, cover * smooth_step(half, 0, std::abs(azimuth(x) - middle)));
        }
    }
}

picture::Picture Canvas::develop() const {
    picture::Picture out{width_, height_, {}};
    out.rgb.reserve(3 * pixels_.size());
    for (const Light& light : pixels_)
        for (const double c : {light.x, light.y, light.z})
            out.rgb.push_back(picture::byte_from_linear(filmic(c)));
    return out;
}

/// Sun through leaves: warm disks about the trees' upper edge, most and brightest near the sun.
void paint_glints(Canvas& canvas, std::uint64_t seed) {
    constexpr std::uint64_t kGlints = 620;
    const RandomStream azimuths(seed, "glint azimuth");
    const RandomStream elevations(seed, "glint elevation");
    const RandomStream sizes(seed, "glint size");
    const RandomStream strengths(seed, "glint strength");
    for (std::uint64_t i = 0; i < kGlints; ++i) {
        const double spread = elevations.uniform(i) + elevations.uniform(i + kGlints) - 1;
        const Sight s = sight(azimuths.uniform(i, -180, 180), 10 + 11 * spread);
        const double glow = Meadow::glow(s);
        const Light light = Light{0.30, 0.42, 0.10} + Light{2.6, 1.5, 0.4} * glow;
        const double strength = strengths.uniform(i);
        const double opacity = (0.03 + 0.34 * strength * strength * strength) * (0.6 + glow);
        canvas.paint(Disk{s, sizes.uniform(i, 0.6, 2.3), light, opacity, sizes.uniform(i + kGlints, 0.5, 0.9)});
    }
}

/// Flowers in drifts of one kind, from far to near: the nearer, the larger and the softer.
void paint_flowers(Canvas& canvas, std::uint64_t seed) {
    constexpr std::uint64_t kFlowers = 1500;
    constexpr std::uint64_t kDrift = 6;  // flowers that stand together
    constexpr Light kColors[] = {{1.30, 1.20, 0.95}, {1.50, 0.86, 0.06}, {1.20, 0.34, 0.50}, {0.46, 0.30, 0.95},
                                 {1.25, 0.12, 0.05}, {1.35, 1.25, 1.10}, {1.30, 0.60, 0.66}};
    const RandomStream places(seed, "flower place");
    const RandomStream sizes(seed, "flower size");
    const RandomStream colors(seed, "flower color");
    const RandomStream strengths(seed, "flower strength");
    for (std::uint64_t i = 0; i < kFlowers; ++i) {
        const std::uint64_t drift = i / kDrift;
        const double nearness = static_cast<double>(i) / kFlowers;
        const double depth = 1.5 + 62 * std::pow(nearness, 2.4) + places.uniform(2 * i, 0, 1 + 2 * nearness);
        const double spread = 5 + 10 * nearness;
        const double azimuth =
            places.uniform(drift + 2 * kFlowers, -180, 180) + spread * (places.uniform(2 * i + 1) - 0.5);
        const Sight s = sight(azimuth, -depth);
        const double radius = (0.20 + 0.075 * depth) * sizes.uniform(i, 0.5, 1.3);
        const Light light = kColors[colors.bits(drift) % std::size(kColors)] * (0.45 + 0.8 * Meadow::glow(s));
        const double opacity =
            strengths.uniform(i, 0.15, 0.70) / (1 + 0.05 * depth) * smooth_step(66, 30, depth);
        canvas.paint(Disk{s, radius, light, opacity, sizes.uniform(i + kFlowers, 0.2, 0.85)});
    }
}

/// Grass close before the lens: wide soft strokes, some lit, some dark.
void paint_blades(Canvas& canvas, std::uint64_t seed) {
    constexpr std::uint64_t kBlades = 420;
    const RandomStream shapes(seed, "blade shape");
    const RandomStream lights(seed, "blade light");
    for (std::uint64_t i = 0; i < kBlades; ++i) {
        const double tip = -5 - 26 * shapes.uniform(4 * i + 1) * shapes.uniform(4 * i + 1);
        const double azimuth = shapes.uniform(4 * i, -180, 180);
        const double glow = Meadow::glow(sight(azimuth, tip));
        const Light lit = Light{0.16, 0.24, 0.03} + Light{1.1, 0.9, 0.12} * (0.6 * glow);
        const Light light = mix({0.008, 0.026, 0.008}, lit, lights.uniform(2 * i));
        canvas.paint(Blade{azimuth, tip - 45, tip, shapes.uniform(4 * i + 2, -9, 9),
                           shapes.uniform(4 * i + 3, 0.5, 1.7), light, lights.uniform(2 * i + 1, 0.15, 0.55)});
    }
}

}  // namespace

picture::Picture make_sky(const SkyRecipe& recipe) {
    for (const int side : {recipe.width, recipe.height})
        if (side < kSmallest || side > kLargest)
            throw Fault(FaultKind::invalid, "A sky of " + std::to_string(recipe.width) + " x " +
                                                std::to_string(recipe.height) +
                                                " pixels was asked for; each side must be from 16 to 16384.");
    Canvas canvas(recipe);
    canvas.paint(Meadow(recipe.seed));
    paint_glints(canvas, recipe.seed);
    paint_flowers(canvas, recipe.seed);
    paint_blades(canvas, recipe.seed);
    return canvas.develop();
}

}  // namespace orbweaver
