#include "weld.hpp"

#include <array>
#include <bit>
#include <cmath>

#include "surface_mesh.hpp"

namespace orbweaver::mesh {

namespace {

using Cell = std::array<double, 3>;

std::uint64_t hash(const Cell& cell) noexcept {
    std::uint64_t h = 0;
    for (const double c : cell) {
        h = (h ^ std::bit_cast<std::uint64_t>(c + 0.0)) * 0x9E3779B97F4A7C15;  // + 0.0 makes -0 a 0
        h ^= h >> 29;
    }
    return h;
}

/// Points by cell: an open-addressed table of chains. Cells of equal hash share a chain, which costs a
/// comparison.
class CellTable {
public:
    explicit CellTable(std::size_t points)
        : heads_(std::bit_ceil(2 * points + 1), kNone), next_(points, kNone), mask_(heads_.size() - 1) {}

    void add(const Cell& cell, std::uint32_t point) {
        std::uint32_t& head = heads_[hash(cell) & mask_];
        next_[point] = head;
        head = point;
    }
    template <class Accept>
    void lowest(const Cell& cell, std::uint32_t& best, Accept&& accept) const {
        for (std::uint32_t p = heads_[hash(cell) & mask_]; p != kNone; p = next_[p])
            if (p < best && accept(p)) best = p;
    }

private:
    std::vector<std::uint32_t> heads_;
    std::vector<std::uint32_t> next_;
    std::uint64_t mask_;
};

std::vector<std::uint32_t> weld_equal(std::span<const Vec3> points) {
    std::vector<std::uint32_t> result(points.size());
    CellTable table(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Cell cell{points[i].x, points[i].y, points[i].z};
        result[i] = i;
        table.lowest(cell, result[i], [&](std::uint32_t p) { return points[p] == points[i]; });
        if (result[i] == i) table.add(cell, i);
    }
    return result;
}

std::vector<std::uint32_t> weld_near(std::span<const Vec3> points, double tolerance) {
    std::vector<std::uint32_t> result(points.size());
    CellTable table(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        const Vec3& point = points[i];
        const Cell cell{std::floor(point.x / tolerance), std::floor(point.y / tolerance),
                        std::floor(point.z / tolerance)};
        result[i] = i;
        for (const double x : {-1.0, 0.0, 1.0})
            for (const double y : {-1.0, 0.0, 1.0})
                for (const double z : {-1.0, 0.0, 1.0})
                    table.lowest({cell[0] + x, cell[1] + y, cell[2] + z}, result[i],
                                 [&](std::uint32_t p) { return distance(points[p], point) <= tolerance; });
        if (result[i] == i) table.add(cell, i);
    }
    return result;
}

}  // namespace

std::vector<std::uint32_t> weld(std::span<const Vec3> points, double tolerance) {
    return tolerance > 0 ? weld_near(points, tolerance) : weld_equal(points);
}

}  // namespace orbweaver::mesh
