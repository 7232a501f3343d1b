#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "orbweaver/random.hpp"
#include "triangle_set.hpp"

namespace orbweaver::surface::test {

struct Ball {
    std::vector<Vec3> vertices;
    std::vector<Corners> triangles;
    TriangleSet set() const { return {vertices, triangles}; }
};

/// A closed ball of `bands` * 2 `bands` facets, every vertex pushed in or out a little by chance.
inline Ball rough_ball(std::uint32_t bands, double radius, const Vec3& middle, std::uint64_t seed = 1) {
    constexpr double kPi = 3.14159265358979323846;
    const RandomStream random(seed, "ball");
    const std::uint32_t around = 2 * bands;
    Ball ball;
    const auto add = [&](const Vec3& direction) {
        const double r = radius * (1 + 0.05 * random.uniform(ball.vertices.size(), -1, 1));
        ball.vertices.push_back(middle + r * direction);
    };
    add({0, 1, 0});
    for (std::uint32_t i = 1; i < bands; ++i)
        for (std::uint32_t j = 0; j < around; ++j) {
            const double a = kPi * i / bands, b = 2 * kPi * j / around;
            add({std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)});
        }
    add({0, -1, 0});
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return 1 + (i - 1) * around + j % around; };
    const auto last = static_cast<std::uint32_t>(ball.vertices.size() - 1);
    for (std::uint32_t j = 0; j < around; ++j) {
        ball.triangles.push_back({0, at(1, j + 1), at(1, j)});
        ball.triangles.push_back({last, at(bands - 1, j), at(bands - 1, j + 1)});
        for (std::uint32_t i = 1; i + 1 < bands; ++i) {
            ball.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
            ball.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
        }
    }
    return ball;
}

}  // namespace orbweaver::surface::test
