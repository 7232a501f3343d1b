#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "large_pages.hpp"
#include "orbweaver/lanes.hpp"
#include "triangle_set.hpp"

namespace orbweaver::surface {

/// The corners of a triangle, coordinate by coordinate, so that one load takes a coordinate of all three: x of
/// corners 0, 1, 2, then y, then z, m. What is loaded in the fourth place means nothing, and is finite.
struct CornerRows {
    std::array<double, 10> at;

    ORBWEAVER_INLINE Lanes row(std::size_t axis) const noexcept { return load(at.data() + 3 * axis); }
};

/// The same of a triangle whose corners lie apart.
struct FarCorners {
    const double *a, *b, *c;

    ORBWEAVER_INLINE FarCorners(const Vec3* vertices, const Corners& corners) noexcept
        : a(&vertices[corners[0]].x), b(&vertices[corners[1]].x), c(&vertices[corners[2]].x) {}
    ORBWEAVER_INLINE Lanes row(std::size_t axis) const noexcept { return Lanes{a[axis], b[axis], c[axis], 0}; }
};

inline CornerRows rows_of(const TriangleSet& set, std::uint32_t face) noexcept {
    const Corners& c = set.triangles[face];
    const Vec3 &p = set.vertices[c[0]], &q = set.vertices[c[1]], &r = set.vertices[c[2]];
    return {{p.x, q.x, r.x, p.y, q.y, r.y, p.z, q.z, r.z, 0}};
}

/// All that a query needs of a face side by side: its corners, and what lies across its edges (codes as
/// mesh::SurfaceMesh::across has them). Each coordinate is a row, as CornerRows has them, that no cache line
/// divides; a code fills the row up, below the exponent of a number from 1 to 2, for denormal ones are dear.
struct alignas(32) FaceRecord {
    struct Row {
        std::array<double, 3> at;
        std::uint32_t across;
        std::uint32_t exponent = 0x3FF00000;
    };
    std::array<Row, 3> rows;

    ORBWEAVER_INLINE Lanes row(std::size_t axis) const noexcept { return load(rows[axis].at.data()); }
};
static_assert(sizeof(FaceRecord) == 96 && std::endian::native == std::endian::little);

inline FaceRecord record_of(const TriangleSet& set, std::uint32_t face, const Corners& across) noexcept {
    const auto [p, q, r] = set.corners(face);
    return {{{{{p.x, q.x, r.x}, across[0]}, {{p.y, q.y, r.y}, across[1]}, {{p.z, q.z, r.z}, across[2]}}}};
}

/// A record a face, in their order; `across` holds as many.
using FaceRecords = std::vector<FaceRecord, LargePages<FaceRecord>>;
inline FaceRecords face_records(const TriangleSet& set, std::span<const Corners> across) {
    FaceRecords records;
    records.reserve(set.triangles.size());
    for (std::uint32_t face = 0; face < set.triangles.size(); ++face)
        records.push_back(record_of(set, face, across[face]));
    return records;
}

}  // namespace orbweaver::surface
