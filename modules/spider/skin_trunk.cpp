#include <algorithm>
#include <cmath>
#include <numbers>

#include "skin.hpp"

/// Thorax with head, waist, abdomen, chelicerae and eyes.
namespace orbweaver::spider {
namespace {

constexpr double kPi = std::numbers::pi;

/// A superellipse's half height at x of its half width.
double cap(double x, double power) noexcept {
    const double inside = 1 - std::pow(std::abs(x), power);
    return inside > 0 ? std::pow(inside, 1 / power) : 0;
}

/// The larger, rounded where they meet.
double round_max(double a, double b) noexcept { return std::pow(std::pow(a, 5) + std::pow(b, 5), 0.2); }

double smooth_step(double from, double to, double x) noexcept {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

Vec3 mix(const Vec3& a, const Vec3& b, double share) noexcept { return a + share * (b - a); }

constexpr Frame kForward{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// The carapace: paler margins, a dark line along its middle, and rays from the pit behind it.
SkinPaint carapace_paint(const Species& species, double x, double y, double z) {
    const Coat& coat = species.coat;
    if (y < -0.1) return {mix(coat.carapace, coat.marks, 0.45), coat.gloss};
    const double side = std::abs(z), from_pit = x / species.body.thorax.x + 0.15;
    const double angle = std::atan2(side * 0.5, from_pit);
    const double rays = std::pow(0.5 + 0.5 * std::cos(7 * angle), 3) * smooth_step(0.05, 0.3, side);
    const double middle = 1 - smooth_step(0.03, 0.16, side);
    Vec3 color = mix(coat.carapace, coat.marks, std::max(0.45 * rays, 0.55 * middle));
    color = mix(color, coat.carapace * 1.18, smooth_step(0.8, 0.98, side));
    return {{std::min(1.0, color.x), std::min(1.0, color.y), std::min(1.0, color.z)}, coat.gloss};
}

void add_prosoma(const Species& species, SkinBuilder& skin) {
    constexpr std::size_t kRings = 26, kSides = 32;
    const Body& body = species.body;
    const double front = body.thorax.x / 2, back = -1.03 * front, tip = front + body.head.x;
    SkinTube tube{{back, 0, 0}, {}, {tip, 0, 0}};
    for (std::size_t i = 1; i <= kRings; ++i) {
        const double x =
            back + (tip - back) * (0.5 - 0.5 * std::cos(kPi * static_cast<double>(i) / (kRings + 1)));
        const double of_thorax = cap(x / (1.04 * front), 2.3), of_head = cap((x - front) / body.head.x, 2.8);
        const double side = round_max(body.thorax.z / 2 * of_thorax, body.head.z / 2 * of_head);
        const double tall = round_max(body.thorax.y * of_thorax, body.head.y * of_head);
        tube.rings.push_back({{x, 0, 0},
                              kForward,
                              0.6 * tall,
                              0.4 * tall,
                              side,
                              {kThorax, kHead, smooth_step(0.7 * front, 1.1 * front, x)}});
    }
    skin.add_tube(tube, kSides, [&](std::size_t ring, double y, double z) {
        return carapace_paint(species, tube.rings[ring].middle.x, y, z);
    });
}

/// The abdomen's back: a heart mark, and chevrons behind it.
SkinPaint abdomen_paint(const Coat& coat, double along, double y, double z) {
    const double side = std::abs(z), gloss = 0.5 * coat.gloss;
    if (y < 0) return {mix(coat.abdomen, coat.marks, 0.15 + 0.25 * smooth_step(0, 0.5, -y)), gloss};
    const double heart = (1 - smooth_step(0.06, 0.16, side)) * (1 - smooth_step(0.42, 0.5, along));
    const double wave = 0.5 + 0.5 * std::cos(2 * kPi * (5.5 * along - 1.4 * side));
    const double width = 0.75 * (1 - along) + 0.12;
    const double chevrons = smooth_step(0.45, 0.75, wave) * smooth_step(0.3, 0.45, along) *
                            (1 - smooth_step(width, width + 0.12, side)) * smooth_step(0.02, 0.1, side);
    const double flank = 0.3 * smooth_step(0.75, 1, side);
    return {mix(coat.abdomen, coat.marks, std::max({0.75 * heart, 0.85 * chevrons, flank})), gloss};
}

void add_abdomen(const Species& species, const BonePlace& bone, SkinBuilder& skin) {
    constexpr std::size_t kRings = 26, kSides = 32;
    const Vec3& size = species.body.abdomen;
    const double start = -0.05 * size.x, length = 1.05 * size.x;
    const double lift = 0.2 * std::max(0.0, size.y - species.body.thorax.y);
    const auto at = [&](double along) { return bone.at + (start + along * length) * bone.axes.x; };
    SkinTube tube{at(0), {}, at(1)};
    std::vector<double> along;
    for (std::size_t i = 1; i <= kRings; ++i) {
        along.push_back(0.5 - 0.5 * std::cos(kPi * static_cast<double>(i) / (kRings + 1)));
        const double t = along.back();
        const double width = cap(2 * std::pow(t, 1.2) - 1, 2.2);
        tube.rings.push_back({at(t) + lift * width * bone.axes.y,
                              bone.axes,
                              0.57 * size.y * width,
                              0.43 * size.y * width,
                              0.5 * size.z * width,
                              {kAbdomen, kAbdomen, 0}});
    }
    skin.add_tube(tube, kSides, [&](std::size_t ring, double y, double z) {
        return abdomen_paint(species.coat, along[ring], y, z);
    });
    for (const double side : {-1.0, 1.0}) {  // spinnerets
        const Vec3 root = at(0.95) + 0.05 * side * size.z * bone.axes.z - 0.04 * size.y * bone.axes.y;
        const double radius = 0.035 * size.z;
        SkinTube tip{root, {}, root + 0.1 * size.x * bone.axes.x};
        for (const double t : {0.1, 0.5, 0.85})
            tip.rings.push_back({root + t * 0.1 * size.x * bone.axes.x,
                                 bone.axes,
                                 radius * (1.1 - 0.6 * t),
                                 radius * (1.1 - 0.6 * t),
                                 radius * (1.1 - 0.6 * t),
                                 {kAbdomen, kAbdomen, 0}});
        skin.add_tube(tip, 8, [&](std::size_t, double, double) {
            return SkinPaint{mix(species.coat.abdomen, species.coat.marks, 0.5), 0.2};
        });
    }
}

void add_waist(const Species& species, const BonePlace& abdomen, SkinBuilder& skin) {
    const Body& body = species.body;
    const double radius = body.waist / 2, reach = std::max(radius, 0.1 * body.abdomen.x);
    SkinTube tube{{abdomen.at.x + reach, 0, 0}, {}, {abdomen.at.x - reach, 0, 0}};
    for (const double along : {0.05, 0.25, 0.5, 0.75, 0.95}) {
        const double r = radius * (0.7 + 0.3 * cap(2 * along - 1, 2));
        tube.rings.push_back({{abdomen.at.x + reach * (1 - 2 * along), 0, 0},
                              abdomen.axes,
                              r,
                              r,
                              r,
                              {kThorax, kAbdomen, smooth_step(0.1, 0.9, along)}});
    }
    skin.add_tube(tube, 14, [&](std::size_t, double, double) {
        return SkinPaint{mix(species.coat.carapace, species.coat.abdomen, 0.5), species.coat.gloss};
    });
}

}  // namespace

void add_trunk(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin) {
    add_prosoma(species, skin);
    add_abdomen(species, rest[kAbdomen], skin);
    add_waist(species, rest[kAbdomen], skin);
}

void add_chelicerae(const Species& species, std::span<const BonePlace> rest, SkinBuilder& skin) {
    const Rod& size = species.body.chelicera;
    if (size.length == 0) return;
    for (const std::size_t bone : {kRightChelicera, kLeftChelicera}) {
        const BonePlace& place = rest[bone];
        const auto along = [&](double t) { return place.at + t * size.length * place.axes.x; };
        SkinTube base{along(-0.15), {}, along(0.85)};
        for (const double t : {-0.12, 0.0, 0.2, 0.4, 0.6, 0.74, 0.82}) {
            const double r = size.thickness / 2 * cap((t - 0.28) / 0.58, 2.6);
            base.rings.push_back({along(t), place.axes, r, r, 0.95 * r, {bone, bone, 0}});
        }
        skin.add_tube(base, 14, [&](std::size_t, double y, double) {
            return SkinPaint{species.coat.chelicerae * (y > 0 ? 1.0 : 0.8), 0.6};
        });
        SkinTube fang{along(0.7), {}, along(1) - 0.25 * size.thickness * place.axes.y};
        for (const double t : {0.75, 0.85, 0.94})
            fang.rings.push_back({along(t) - 0.8 * (t - 0.75) * size.thickness * place.axes.y,
                                  place.axes,
                                  0.5 * (1.02 - t) * size.thickness,
                                  0.5 * (1.02 - t) * size.thickness,
                                  0.5 * (1.02 - t) * size.thickness,
                                  {bone, bone, 0}});
        skin.add_tube(fang, 8, [](std::size_t, double, double) { return SkinPaint{{0.04, 0.02, 0.02}, 0.9}; });
    }
}

void add_eyes(const Species& species, SkinBuilder& skin) {
    constexpr SkinPaint kEye{{0.015, 0.012, 0.012}, 1};
    for (const Eye& eye : species.coat.eyes) {
        skin.add_ball(eye.at, eye.radius, kHead, kEye);
        skin.add_ball({eye.at.x, eye.at.y, -eye.at.z}, eye.radius, kHead, kEye);
    }
}

}  // namespace orbweaver::spider
