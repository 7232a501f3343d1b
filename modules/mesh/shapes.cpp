#include "shapes.hpp"

#include <array>

#include "orbweaver/exact_math.hpp"

namespace orbweaver::mesh {

namespace {

/// Quads over (n + 1) x (m + 1) points, counter-clockwise where u x v points at the viewer.
template <class Point>
void add_grid(RawMesh& raw, std::uint32_t n, std::uint32_t m, Point&& point) {
    const auto base = static_cast<std::uint32_t>(raw.points.size());
    for (std::uint32_t j = 0; j <= m; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) raw.points.push_back(point(i, j));
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t at = base + j * (n + 1) + i;
            raw.add_polygon({at, at + 1, at + n + 2, at + n + 1});
        }
}

/// A place between two: the same bits wherever two sides of a shape meet, so that they weld.
double between(double from, double to, std::uint32_t i, std::uint32_t n) {
    if (from == to) return from;
    return (from * static_cast<double>(n - i) + to * i) / n;
}

Vec3 between(const Vec3& from, const Vec3& to, std::uint32_t i, std::uint32_t n) {
    return {between(from.x, to.x, i, n), between(from.y, to.y, i, n), between(from.z, to.z, i, n)};
}

double turn(std::uint32_t i, std::uint32_t n) { return 360.0 * (i % n) / n; }  // degrees

void add_parallelogram(RawMesh& raw, const Vec3& corner, const Vec3& u, const Vec3& v, std::uint32_t n,
                       std::uint32_t m) {
    add_grid(raw, n, m, [&](std::uint32_t i, std::uint32_t j) {
        return between(between(corner, corner + u, i, n), between(corner + v, corner + u + v, i, n), j, m);
    });
}

RawMesh named(const char* name) {
    RawMesh raw;
    raw.material_names = {name};
    return raw;
}

RawMesh box(const char* name, double size, std::uint32_t n, bool inwards) {
    RawMesh raw = named(name);
    const double h = size / 2;
    const Vec3 x{size, 0, 0}, y{0, size, 0}, z{0, 0, size};
    struct Side {
        Vec3 corner, u, v;
    };
    const std::array<Side, 6> sides = {{{{-h, -h, h}, x, y},
                                        {{-h, -h, -h}, y, x},
                                        {{h, -h, -h}, y, z},
                                        {{-h, -h, -h}, z, y},
                                        {{-h, h, -h}, z, x},
                                        {{-h, -h, -h}, x, z}}};
    for (const auto& [corner, u, v] : sides)
        inwards ? add_parallelogram(raw, corner, v, u, n, n) : add_parallelogram(raw, corner, u, v, n, n);
    return raw;
}

}  // namespace

RawMesh cube(double size, std::uint32_t subdivision) { return box("cube", size, subdivision, false); }
RawMesh room(double size, std::uint32_t subdivision) { return box("room", size, subdivision, true); }

RawMesh sphere(double size, std::uint32_t subdivision) {
    RawMesh raw = named("sphere");
    const std::uint32_t meridians = 4 * subdivision, bands = 2 * subdivision;
    const double radius = size / 2;
    raw.points.push_back({0, -radius, 0});
    for (std::uint32_t band = 1; band < bands; ++band)
        for (std::uint32_t i = 0; i < meridians; ++i) {
            const double latitude = between(-90, 90, band, bands);
            const double flat = radius * cos_degrees(latitude);
            raw.points.push_back({flat * cos_degrees(turn(i, meridians)), radius * sin_degrees(latitude),
                                  -flat * sin_degrees(turn(i, meridians))});
        }
    raw.points.push_back({0, radius, 0});
    const auto top = static_cast<std::uint32_t>(raw.points.size() - 1);
    const auto at = [&](std::uint32_t band, std::uint32_t i) {
        return 1 + (band - 1) * meridians + i % meridians;
    };
    for (std::uint32_t i = 0; i < meridians; ++i) {
        raw.add_polygon({0, at(1, i + 1), at(1, i)});
        for (std::uint32_t band = 1; band + 1 < bands; ++band)
            raw.add_polygon({at(band, i), at(band, i + 1), at(band + 1, i + 1), at(band + 1, i)});
        raw.add_polygon({top, at(bands - 1, i), at(bands - 1, i + 1)});
    }
    return raw;
}

RawMesh height_field(double size, std::uint32_t subdivision) {
    RawMesh raw = named("height_field");
    const std::uint32_t n = subdivision;
    add_grid(raw, n, n, [&](std::uint32_t i, std::uint32_t j) {
        const double x = between(-0.5, 0.5, i, n), z = between(0.5, -0.5, j, n);
        const double hills =
            sin_degrees(720 * x + 40) * cos_degrees(540 * z) + 0.5 * sin_degrees(1800 * (x + z));
        return Vec3{size * x, size * hills / 30, size * z};
    });
    return raw;
}

RawMesh cliff(double size, std::uint32_t subdivision) {
    RawMesh raw = named("cliff");
    const double s = size / 2;
    const std::array<Vec3, 4> profile = {{{-s, 0, s}, {0, 0, s}, {-0.5 * s, s, s}, {s, s, s}}};
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        add_parallelogram(raw, profile[i], profile[i + 1] - profile[i], {0, 0, -size}, subdivision,
                          subdivision);
    return raw;
}

RawMesh torus(double size, std::uint32_t subdivision) {
    RawMesh raw = named("torus");
    const std::uint32_t n = 4 * subdivision, m = 2 * subdivision;
    const double tube = size / 8, ring = size / 2 - tube;
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const double flat = ring + tube * cos_degrees(turn(j, m));
            raw.points.push_back({flat * cos_degrees(turn(i, n)), tube * sin_degrees(turn(j, m)),
                                  -flat * sin_degrees(turn(i, n))});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return (j % m) * n + i % n; };
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i)
            raw.add_polygon({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return raw;
}

RawMesh moebius_strip(double size, std::uint32_t subdivision) {
    RawMesh raw = named("moebius_strip");
    const std::uint32_t n = 8 * subdivision, m = subdivision;
    const double half_width = size / 8, ring = size / 2 - half_width;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j <= m; ++j) {
            const double across = between(-half_width, half_width, j, m);
            const double flat = ring + across * cos_degrees(turn(i, n) / 2);
            raw.points.push_back({flat * cos_degrees(turn(i, n)), across * sin_degrees(turn(i, n) / 2),
                                  -flat * sin_degrees(turn(i, n))});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i < n ? i * (m + 1) + j : m - j; };
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j)
            raw.add_polygon({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    return raw;
}

RawMesh fan(double size, std::uint32_t subdivision) {
    RawMesh raw = named("fan");
    for (const double degrees : {0.0, 120.0, 240.0}) {
        const Vec3 out{size / 2 * cos_degrees(degrees), 0, -size / 2 * sin_degrees(degrees)};
        add_parallelogram(raw, {0, -size / 2, 0}, out, {0, size, 0}, subdivision, subdivision);
    }
    return raw;
}

RawMesh bow_tie(double size, std::uint32_t subdivision) {
    RawMesh raw = named("bow_tie");
    const std::uint32_t n = subdivision;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 tip{}, left{side * size / 2, -side * size / 2, 0},
            right{side * size / 2, side * size / 2, 0};
        const auto base = static_cast<std::uint32_t>(raw.points.size());
        const auto at = [&](std::uint32_t row, std::uint32_t i) { return base + row * (row + 1) / 2 + i; };
        for (std::uint32_t row = 0; row <= n; ++row)
            for (std::uint32_t i = 0; i <= row; ++i)
                raw.points.push_back(
                    row == 0 ? tip : between(between(tip, left, row, n), between(tip, right, row, n), i, row));
        for (std::uint32_t row = 0; row < n; ++row)
            for (std::uint32_t i = 0; i <= row; ++i) {
                raw.add_polygon({at(row, i), at(row + 1, i), at(row + 1, i + 1)});
                if (i < row) raw.add_polygon({at(row, i), at(row + 1, i + 1), at(row, i + 1)});
            }
    }
    return raw;
}

RawMesh t_junction(double size, std::uint32_t subdivision) {
    RawMesh raw = named("t_junction");
    const double h = size / 2;
    add_parallelogram(raw, {-h, 0, h}, {h, 0, 0}, {0, 0, -size}, subdivision, subdivision);
    add_parallelogram(raw, {0, 0, h}, {h, 0, 0}, {0, 0, -size}, 2 * subdivision, 2 * subdivision);
    return raw;
}

RawMesh branch(double size, std::uint32_t subdivision) {
    RawMesh raw = named("branch");
    const std::uint32_t around = 6 * subdivision, along = 8 * subdivision;
    for (std::uint32_t j = 0; j <= along; ++j)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double t = between(0, 1, j, along);
            const double radius = size * between(0.06, 0.02, j, along);
            const Vec3 middle{0.15 * size * sin_degrees(180 * t), size * (t - 0.5),
                              0.1 * size * sin_degrees(360 * t)};
            raw.points.push_back(middle + Vec3{radius * cos_degrees(turn(i, around)), 0,
                                               -radius * sin_degrees(turn(i, around))});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * around + i % around; };
    for (std::uint32_t j = 0; j < along; ++j)
        for (std::uint32_t i = 0; i < around; ++i)
            raw.add_polygon({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    for (const bool top : {false, true}) {
        for (std::uint32_t i = 0; i < around; ++i)
            raw.corners.push_back(top ? at(i, along) : at(around - 1 - i, 0));
        raw.first.push_back(static_cast<std::uint32_t>(raw.corners.size()));
        raw.material.push_back(0);
    }
    return raw;
}

std::span<const Shape> shapes() noexcept {
    static constexpr std::array<Shape, 11> kShapes = {{
        {"bow_tie", "two triangles that touch in one point", bow_tie},
        {"branch", "a bent, tapering stem, closed by a polygon at each end", branch},
        {"cliff", "ground, a wall that leans out over it, and a plateau", cliff},
        {"cube", "a cube, to be walked on from outside", cube},
        {"fan", "three blades that meet in one edge", fan},
        {"height_field", "hills", height_field},
        {"moebius_strip", "a strip of one side", moebius_strip},
        {"room", "a cube, to be walked on from inside", room},
        {"sphere", "a sphere", sphere},
        {"t_junction", "squares beside squares half as wide: corners lie on edges", t_junction},
        {"torus", "a ring", torus},
    }};
    return kShapes;
}

RawMesh transformed(RawMesh raw, double scale, const Vec3& offset) {
    for (Vec3& point : raw.points) point = point * scale + offset;
    return raw;
}

}  // namespace orbweaver::mesh
