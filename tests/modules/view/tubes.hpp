#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "orbweaver/contracts/patches.hpp"

namespace orbweaver::test {

/// Straight white tubes along x, their tails to the left, of rings that are regular and 1 m apart: skin from 1
/// m after the first to 1 m before the last. The first point of a ring is above its middle.
struct Tubes final : Patches {
    PatchLayout shape;
    std::vector<Vec3> now;
    PatchMap wrap;
    std::vector<std::uint8_t> texels{255, 255, 255, 0};

    /// One around each of `places`; points are `radius` from the axis, turned by `turn` (rad).
    Tubes(const std::vector<Vec3>& places, std::size_t rings, std::size_t sides, double radius = 1,
          double turn = 0)
        : shape{places.size(), rings, sides} {
        for (const Vec3& place : places)
            for (std::size_t ring = 0; ring < rings; ++ring)
                for (std::size_t side = 0; side < sides; ++side) {
                    const double angle =
                        turn + 2 * std::numbers::pi * static_cast<double>(side) / static_cast<double>(sides);
                    const double x = static_cast<double>(ring) - static_cast<double>(rings - 1) / 2;
                    now.push_back(place + Vec3{x, radius * std::cos(angle), radius * std::sin(angle)});
                }
        paint(1, 1, texels);
    }
    Tubes(const Tubes&) = delete;
    Tubes& operator=(const Tubes&) = delete;
    ~Tubes() = default;

    void paint(std::uint32_t columns, std::uint32_t rows, const std::vector<std::uint8_t>& rgb_and_height) {
        texels = rgb_and_height;
        wrap.columns = columns;
        wrap.rows = rows;
        wrap.texels = texels;
    }
    /// The points of a ring of the first body.
    std::span<Vec3> ring(std::size_t which) { return std::span(now).subspan(which * shape.sides, shape.sides); }
    /// All of a ring to its middle.
    void collapse(std::size_t which) {
        Vec3 middle;
        for (const Vec3& point : ring(which)) middle += point / static_cast<double>(shape.sides);
        for (Vec3& point : ring(which)) point = middle;
    }
    PatchLayout layout() const noexcept override { return shape; }
    PatchMap map() override { return wrap; }
    std::span<const Vec3> points() override { return now; }
};

}  // namespace orbweaver::test
