#pragma once

#include <array>
#include <vector>

#include "orbweaver/contracts/skins.hpp"

namespace orbweaver::test {

/// Red square plates of 2 x 2 m in the xy plane, seen from +z; their left corners go with bone 0, the right
/// ones with bone 1.
struct Plates final : Skins {
    std::vector<SkinVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    std::vector<SkinRod> rods{{{-1, 0, 0}, {0, 0, 0}, 0.3}, {{0, 0, 0}, {1, 0, 0}, 0.3}};
    std::vector<SkinMove> now;

    /// Each stands at one of `places`.
    explicit Plates(const std::vector<Vec3>& places) {
        for (const auto& [x, y] : {std::pair{-1.F, -1.F}, {1.F, -1.F}, {1.F, 1.F}, {-1.F, 1.F}})
            vertices.push_back(
                {{x, y, 0}, {0, 0, 1}, {1, 0, 0}, 0, {0, 1}, {x < 0 ? 1.F : 0.F, x < 0 ? 0.F : 1.F}});
        for (const Vec3& place : places)
            for (int bone = 0; bone < 2; ++bone) now.push_back({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, place});
    }
    SkinMesh mesh() override { return {vertices, triangles, rods}; }
    std::span<const SkinMove> moves() override { return now; }
};

}  // namespace orbweaver::test
