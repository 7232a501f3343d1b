#include "t_junctions.hpp"

#include <catch2/catch.hpp>

#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

namespace {

RawMesh in_single_precision(RawMesh raw) {
    for (Vec3& p : raw.points) p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    return raw;
}

}  // namespace

TEST_CASE("every second vertex of the finer half lies on an edge of the coarser one", "[unit]") {
    for (const std::uint32_t n : {1U, 2U, 7U, 40U}) {
        CAPTURE(n);
        const Validation found = test::validation_of(t_junction(2, n));
        CHECK(found.t_junctions == n);
        CHECK(found.first_t_junction != kNone);
    }
}

TEST_CASE("T-junctions are found at any scale and place, turned, and rounded to single precision",
          "[extreme]") {
    RawMesh turned = t_junction(2, 8);
    for (Vec3& p : turned.points) p = {0.6 * p.x - 0.8 * p.z, p.y + 0.3 * p.z, 0.8 * p.x + 0.6 * p.z};
    for (const double scale : {1e-8, 1.0, 1e6})
        for (const double offset : {0.0, 100.0}) {
            CAPTURE(scale, offset);
            const Vec3 by = scale * Vec3{offset, -2 * offset, offset};
            CHECK(test::validation_of(transformed(turned, scale, by)).t_junctions == 8);
            CHECK(test::validation_of(in_single_precision(transformed(turned, scale, by))).t_junctions == 8);
        }
}

TEST_CASE("borders alone are no T-junctions, nor are corners that only come near", "[unit]") {
    for (const auto& raw : {cube(1, 3), height_field(1, 5), moebius_strip(1, 2), bow_tie(1, 3), fan(1, 2)})
        CHECK(test::validation_of(raw).t_junctions == 0);
    // A triangle whose tip ends a thousandth before an edge's middle, on it, and a thousandth beyond.
    for (const double off : {-1e-3, 0.0, 1e-3}) {
        const Validation found = test::validation_of(
            test::raw_mesh({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, off, 0}, {0, -1, 0}, {1, -1, 0}},
                           {{0, 1, 2}, {3, 4, 5}}));
        CHECK(found.t_junctions == (off == 0 ? 1 : 0));
        CHECK(found.first_t_junction == (off == 0 ? 3 : kNone));
    }
}
