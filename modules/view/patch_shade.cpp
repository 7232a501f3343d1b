#include "patch_shade.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbweaver::view {
namespace {

constexpr double kMostRods = 24;  // of a body: each is a box drawn
constexpr double kRodLength = 3;  // radii, where that many are enough: shorter ones would look no rounder
constexpr double kThrown = 8;     // radii, how far shadows go: bodies lie rather than stand

constexpr const char* kRods = R"(
uniform samplerBuffer rods;
void find_rod(int i, out vec4 from, out vec3 to) {
    from = texelFetch(rods, 2 * i);
    to = texelFetch(rods, 2 * i + 1).xyz;
}
)";

/// A ring's middle, and how far its points are from there.
struct Round {
    Vec3 middle;        // m
    double radius = 0;  // m, the mean
};

Round ring_round(std::span<const Vec3> ring) {
    const auto count = static_cast<double>(ring.size());
    Round round;
    for (const Vec3& point : ring) round.middle += point / count;
    for (const Vec3& point : ring) round.radius += distance(point, round.middle) / count;
    return round;
}

/// Where a B-spline along the rings is at its knots, one at each ring but the first and the last; a regular
/// ring's points pull the skin between them in to the factor that a closed B-spline has at its knots.
std::vector<Round> knots(const PatchLayout& layout, std::span<const Vec3> body) {
    const auto sides = static_cast<double>(layout.sides);
    const double skin = (2 + std::cos(2 * std::numbers::pi / sides)) / 3;
    std::vector<Round> rounds, knots;
    for (std::size_t ring = 0; ring < layout.rings; ++ring)
        rounds.push_back(ring_round(body.subspan(ring * layout.sides, layout.sides)));
    for (std::size_t i = 1; i + 1 < rounds.size(); ++i) {
        const Round &a = rounds[i - 1], &b = rounds[i], &c = rounds[i + 1];
        knots.push_back(
            {(a.middle + 4 * b.middle + c.middle) / 6, skin * (a.radius + 4 * b.radius + c.radius) / 6});
    }
    return knots;
}

TubeRod rod_between(std::span<const Round> knots) {
    TubeRod rod{knots.front().middle, knots.back().middle, 0};
    for (const Round& knot : knots) rod.radius += knot.radius / static_cast<double>(knots.size());
    constexpr double kNoLength = 1e-3;  // of the radius: shade would divide by it
    if (distance(rod.from, rod.to) <= kNoLength * rod.radius) rod.radius = 0;
    return rod;
}

/// How many rods are enough for a body.
std::size_t rod_count(std::span<const Round> knots) {
    const auto spans = static_cast<double>(knots.size() - 1);
    double length = 0, radius = 0;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        length += distance(knots[i].middle, knots[i + 1].middle);
        radius += (knots[i].radius + knots[i + 1].radius) / 2 / spans;
    }
    const double most = std::min(kMostRods, spans);
    return static_cast<std::size_t>(radius > 0 ? std::clamp(length / (kRodLength * radius), 1.0, most) : 1.0);
}

}  // namespace

std::vector<TubeRod> tube_rods(const PatchLayout& layout, std::span<const Vec3> points) {
    std::vector<TubeRod> rods;
    const std::size_t body = layout.rings * layout.sides;
    for (std::size_t b = 0; b < layout.bodies; ++b) {
        const auto along = knots(layout, points.subspan(b * body, body));
        const std::size_t last = along.size() - 1, count = rod_count(along);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t from = i * last / count, to = (i + 1) * last / count;
            rods.push_back(rod_between(std::span(along).subspan(from, to - from + 1)));
        }
    }
    return rods;
}

PatchShade::PatchShade(const Gl& gl, const KeyLight& key) : pass_(gl, kRods, Joints::chained, key), rods_(gl) {}

void PatchShade::upload(const std::vector<TubeRod>& rods, const Vec3& origin) {
    texels_.clear();
    for (const TubeRod& rod : rods) {
        const Vec3 a = rod.from - origin, b = rod.to - origin;
        for (const double number : {a.x, a.y, a.z, rod.radius, b.x, b.y, b.z, 0.0})
            texels_.push_back(static_cast<float>(number));
    }
    rods_.upload(texels_, GL_STREAM_DRAW, 1);
}

void PatchShade::draw(const PatchPoints& points, GLuint depths, const Camera& camera, int width, int height) {
    const PatchLayout& layout = points.layout();
    if (layout.bodies == 0) return;
    const auto rods = tube_rods(layout, points.latest());
    double thickest = 0;
    for (const TubeRod& rod : rods) thickest = std::max(thickest, rod.radius);
    upload(rods, points.origin());
    pass_.draw({static_cast<GLsizei>(rods.size()), 0, points.origin(), kThrown * thickest}, depths, camera,
               width, height);
}

}  // namespace orbweaver::view
