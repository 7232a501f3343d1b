#include "neighbors.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::spider {
namespace {

constexpr int kBits = 21;  // of a cell's number along an axis, and so of the steps between columns
constexpr std::int64_t kNextY = std::int64_t{1} << kBits, kNextX = kNextY << kBits;

}  // namespace

Neighbors::Cell Neighbors::cell_of(const Vec3& position) const noexcept {
    constexpr double kMost = 1 << (kBits - 2);  // cells; farther out all share one
    const auto along = [&](double x) {
        return static_cast<std::int64_t>(std::floor(std::clamp(x / reach_, -kMost, kMost)));
    };
    return along(position.x) * kNextX + along(position.y) * kNextY + along(position.z);
}

void Neighbors::gather(std::span<const Vec3> positions, double reach) {
    positions_ = positions;
    reach_ = reach;
    cells_.clear();
    cells_.reserve(positions.size());
    columns_.resize(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (is_finite(positions[i])) cells_.push_back({columns_[i].cell = cell_of(positions[i]), i});
    std::sort(cells_.begin(), cells_.end());
    std::size_t column = 0;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy) find_columns(column++, dx * kNextX + dy * kNextY);
}

/// In one pass: the later the cell, the later is its neighbor.
void Neighbors::find_columns(std::size_t column, Cell offset) noexcept {
    std::size_t begin = 0;
    for (const Entry& entry : cells_) {
        while (begin < cells_.size() && cells_[begin].cell < entry.cell + offset - 1) ++begin;
        columns_[entry.index].begin[column] = static_cast<std::uint32_t>(begin);
    }
}

std::size_t Neighbors::around(std::size_t i, std::span<Vec3> near) const noexcept {
    std::size_t count = 0;
    const Vec3& here = positions_[i];
    if (!is_finite(here) || near.empty()) return 0;
    const auto is_nearer = [&](const Vec3& a, const Vec3& b) { return distance(here, a) < distance(here, b); };
    const Columns& columns = columns_[i];
    std::size_t column = 0;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
            const Cell last = columns.cell + dx * kNextX + dy * kNextY + 1;
            for (std::size_t at = columns.begin[column++]; at < cells_.size() && cells_[at].cell <= last;
                 ++at) {
                const Vec3& other = positions_[cells_[at].index];
                if (cells_[at].index == i || !(distance(here, other) < reach_)) continue;
                if (count < near.size()) {
                    near[count++] = other;
                    if (count == near.size()) std::make_heap(near.begin(), near.end(), is_nearer);
                } else if (is_nearer(other, near.front())) {
                    std::pop_heap(near.begin(), near.end(), is_nearer);  // the farthest makes room
                    near.back() = other;
                    std::push_heap(near.begin(), near.end(), is_nearer);
                }
            }
        }
    return count;
}

}  // namespace orbweaver::spider
