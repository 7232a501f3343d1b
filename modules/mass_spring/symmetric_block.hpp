#pragma once

#include "network.hpp"
#include "orbweaver/vec3.hpp"
#include "spring_force.hpp"

namespace orbweaver::mass_spring {

/// A symmetric 3x3 matrix.
struct SymmetricBlock {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

/// What a spring of extent l = x_a - x_b contributes to the tangent stiffness -(df/dx), with the signs + + - -
/// of its two ends: with n = l/|l|, T' n n^T + (T/|l|)(I - n n^T). Where `clamped`, the
/// second part is left out in compression, so that the block is semi-definite (Baraff and Witkin 1998; Choi and
/// Ko 2002). A spring whose ends meet has no direction and no block.
SymmetricBlock stiffness_block(const Vec3& l, const Tension& tension, bool clamped) noexcept;

/// To the tangent damping -(df/dv): c n n^T.
SymmetricBlock damping_block(const Spring& spring, const Vec3& l) noexcept;

constexpr SymmetricBlock operator*(double s, const SymmetricBlock& b) noexcept {
    return {s * b.xx, s * b.xy, s * b.xz, s * b.yy, s * b.yz, s * b.zz};
}
constexpr SymmetricBlock operator+(const SymmetricBlock& a, const SymmetricBlock& b) noexcept {
    return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yy + b.yy, a.yz + b.yz, a.zz + b.zz};
}

}  // namespace orbweaver::mass_spring
