#include "symmetric_block.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

Vec3 times(const SymmetricBlock& b, const Vec3& u) {
    return {b.xx * u.x + b.xy * u.y + b.xz * u.z, b.xy * u.x + b.yy * u.y + b.yz * u.z,
            b.xz * u.x + b.yz * u.y + b.zz * u.z};
}

}  // namespace

TEST_CASE("a block is k along the spring and T/|l| across it", "[unit]") {
    const Tension taut = tension_at({0, 1, 4, 10, 0}, 1);
    const Vec3 l{3, 0, 4};  // |l| = 5: T = 10 N, T/|l| = 2 N/m
    const SymmetricBlock block = stiffness_block(l, taut, false);
    CHECK(norm(times(block, l) - 10 * l) < 1e-13);
    CHECK(norm(times(block, {0, 1, 0}) - Vec3{0, 2, 0}) < 1e-14);
    CHECK(norm(times(block, {4, 0, -3}) - 2.0 * Vec3{4, 0, -3}) < 1e-13);
}

TEST_CASE("clamping leaves out what compression takes away", "[unit]") {
    const Tension pressed = tension_at({0, 1, 10, 10, 0}, -5);
    const Vec3 l{0, 5, 0};  // T = -50 N
    CHECK(stiffness_block(l, pressed, false).xx == Approx(-10));
    CHECK(stiffness_block(l, pressed, true).xx == 0);
    CHECK(stiffness_block(l, pressed, true).yy == Approx(10));
}

TEST_CASE("a spring whose ends meet has no block", "[unit]") {
    const SymmetricBlock block = stiffness_block({}, {-10, 10}, false);
    CHECK(norm(times(block, {1, 1, 1})) == 0);
}
