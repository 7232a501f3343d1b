#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "orbweaver/vec3.hpp"

namespace orbweaver::spider {

/// Who is near whom in a crowd: a grid of cells as wide as the reach, sorted, so that each looks into the 27
/// cells about its own. Allocates when the crowd grows, not else.
class Neighbors {
public:
    /// Of creatures at `positions` (m), which outlive the next calls, each seeing as far as `reach` m (> 0).
    void gather(std::span<const Vec3> positions, double reach);
    /// Puts the places of others within the reach of creature `i` into `near`, the nearest of them where not
    /// all fit; returns how many those are.
    std::size_t around(std::size_t i, std::span<Vec3> near) const noexcept;
    std::size_t memory_bytes() const noexcept {
        return cells_.capacity() * sizeof(Entry) + columns_.capacity() * sizeof(Columns);
    }

private:
    /// A cell's three numbers in one, x before y before z: of neighbors along z, one is one more.
    using Cell = std::int64_t;
    struct Entry {
        Cell cell = 0;
        std::uint32_t index = 0;
        friend bool operator<(const Entry& a, const Entry& b) noexcept {
            return a.cell != b.cell ? a.cell < b.cell : a.index < b.index;
        }
    };
    /// Where the three cells along z begin among all, in each of the nine columns about a creature's cell.
    struct Columns {
        Cell cell = 0;
        std::array<std::uint32_t, 9> begin{};
    };
    Cell cell_of(const Vec3& position) const noexcept;
    void find_columns(std::size_t column, Cell offset) noexcept;

    std::span<const Vec3> positions_;
    double reach_ = 1;
    std::vector<Entry> cells_;      ///< in order
    std::vector<Columns> columns_;  ///< of each creature
};

}  // namespace orbweaver::spider
