#include "skin_builder.hpp"

#include <algorithm>
#include <cmath>

#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {
namespace {

std::array<float, 3> floats(const Vec3& v) noexcept {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Vec3 doubles(const std::array<float, 3>& v) noexcept { return {v[0], v[1], v[2]}; }

Vec3 unit(const Vec3& v) noexcept { return v / std::max(norm(v), 1e-300); }

}  // namespace

Vec3 SkinBuilder::around(std::size_t side, std::size_t sides) noexcept {
    const double degrees = 360.0 * static_cast<double>(side) / static_cast<double>(sides);
    return {0, cos_degrees(degrees), sin_degrees(degrees)};
}

std::uint32_t SkinBuilder::add_vertex(const Vec3& position, const SkinBinding& binding,
                                      const SkinPaint& paint) {
    const auto share = static_cast<float>(std::round(binding.share * 1024) / 1024);  // 1 - share is exact
    vertices.push_back({floats(position),
                        {},
                        floats(paint.color),
                        static_cast<float>(paint.gloss),
                        {static_cast<std::uint32_t>(binding.a), static_cast<std::uint32_t>(binding.b)},
                        {1 - share, share}});
    return static_cast<std::uint32_t>(vertices.size() - 1);
}

void SkinBuilder::join(std::uint32_t start, std::size_t rings, std::size_t sides) {
    const auto corner = [&](std::size_t ring, std::size_t side) {
        return start + 1 + static_cast<std::uint32_t>(ring * sides + side % sides);
    };
    const std::uint32_t end = corner(rings, 0);
    for (std::size_t i = 0; i < sides; ++i) {
        triangles.push_back({start, corner(0, i + 1), corner(0, i)});
        for (std::size_t r = 0; r + 1 < rings; ++r) {
            triangles.push_back({corner(r, i), corner(r, i + 1), corner(r + 1, i + 1)});
            triangles.push_back({corner(r, i), corner(r + 1, i + 1), corner(r + 1, i)});
        }
        triangles.push_back({corner(rings - 1, i), corner(rings - 1, i + 1), end});
    }
}

void SkinBuilder::add_ball(const Vec3& middle, double radius, std::size_t bone, const SkinPaint& paint) {
    constexpr std::size_t kRings = 7, kSides = 12;
    SkinTube tube{middle - Vec3{radius, 0, 0}, {}, middle + Vec3{radius, 0, 0}};
    for (std::size_t i = 1; i <= kRings; ++i) {
        const double degrees = 180.0 * static_cast<double>(i) / (kRings + 1);
        const double r = radius * sin_degrees(degrees);
        tube.rings.push_back({middle - Vec3{radius * cos_degrees(degrees), 0, 0},
                              {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                              r,
                              r,
                              r,
                              {bone, bone, 0}});
    }
    add_tube(tube, kSides, [&](std::size_t, double, double) { return paint; });
}

void SkinBuilder::smooth() {
    std::vector<Vec3> sums(vertices.size());
    for (const auto& t : triangles) {
        const Vec3 a = doubles(vertices[t[0]].position);
        const Vec3 area = cross(doubles(vertices[t[1]].position) - a, doubles(vertices[t[2]].position) - a);
        for (const std::uint32_t corner : t) sums[corner] += area;
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i].normal = floats(unit(sums[i]));
}

void SkinBuilder::add_fur(const SkinFur& fur, std::span<const Vec3> leans, const RandomStream& random) {
    std::vector<double> areas;  // up to each triangle's end
    double area = 0;
    for (std::size_t i = fur.first; i < fur.end; ++i) {
        const auto& t = triangles[i];
        const Vec3 a = doubles(vertices[t[0]].position);
        area += norm(cross(doubles(vertices[t[1]].position) - a, doubles(vertices[t[2]].position) - a));
        areas.push_back(area);
    }
    for (std::size_t i = 0; i < fur.count; ++i) {
        std::array<double, 5> chance;
        for (std::size_t k = 0; k < chance.size(); ++k) chance[k] = random.uniform(6 * i + k);
        const double at = area * random.uniform(6 * i + 5);
        const auto which =
            static_cast<std::size_t>(std::lower_bound(areas.begin(), areas.end(), at) - areas.begin());
        const auto skin = triangles[fur.first + std::min(which, areas.size() - 1)];
        const SkinVertex& corner = vertices[skin[0]];
        add_hair(skin, fur, leans[corner.bones[corner.weights[1] > 0.5F ? 1 : 0]], chance);
    }
}

/// `chance`: where on the triangle (two), how long, which way around, how light; each in [0, 1).
void SkinBuilder::add_hair(const std::array<std::uint32_t, 3>& skin, const SkinFur& fur, const Vec3& lean,
                           const std::array<double, 5>& chance) {
    double u = chance[0], v = chance[1];
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const std::array<double, 3> weights{1 - u - v, u, v};
    Vec3 root, normal, color;
    for (std::size_t k = 0; k < 3; ++k) {
        root += weights[k] * doubles(vertices[skin[k]].position);
        normal += weights[k] * doubles(vertices[skin[k]].normal);
        color += weights[k] * doubles(vertices[skin[k]].color);
    }
    normal = unit(normal);
    const SkinVertex below = vertices[skin[0]];
    const Vec3 flat = unit(across(lean, normal)), beside = cross(normal, flat);
    const double turn = 0.7 * (chance[3] - 0.5);
    const Vec3 way = unit(0.8 * normal + 0.9 * flat + turn * beside);
    const double length = fur.length * (0.5 + chance[2]);
    const double light = 0.75 + 0.9 * chance[4];
    const SkinPaint paint{
        {std::min(1.0, color.x * light), std::min(1.0, color.y * light), std::min(1.0, color.z * light)}, 0};
    const SkinBinding binding{below.bones[0], below.bones[1], below.weights[1]};
    // Three corners below the skin, about the hair's axis, and its tip.
    const Vec3 across_a = unit(cross(way, beside + 0.1 * flat)), across_b = cross(way, across_a);
    const Vec3 base = root - 0.1 * length * way;
    std::array<std::uint32_t, 4> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double degrees = 120.0 * static_cast<double>(k);
        corners[k] = add_vertex(
            base + fur.width / 2 * (cos_degrees(degrees) * across_a + sin_degrees(degrees) * across_b), binding,
            paint);
    }
    corners[3] = add_vertex(root + length * way, binding, paint);
    for (const std::uint32_t corner : corners) vertices[corner].normal = floats(unit(normal + 0.3 * way));
    triangles.push_back({corners[0], corners[2], corners[1]});
    for (std::size_t k = 0; k < 3; ++k) triangles.push_back({corners[k], corners[(k + 1) % 3], corners[3]});
}

}  // namespace orbweaver::spider
