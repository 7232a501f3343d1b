#include "neighbors.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::spider {

Neighbors::Cell Neighbors::cell_of(const Vec3& position) const noexcept {
    constexpr double kMost = 1e15;  // cells; farther out all share one
    const auto along = [&](double x) {
        return static_cast<std::int64_t>(std::floor(std::clamp(x / reach_, -kMost, kMost)));
    };
    return {along(position.x), along(position.y), along(position.z)};
}

void Neighbors::gather(std::span<const Vec3> positions, double reach) {
    positions_ = positions;
    reach_ = reach;
    cells_.clear();
    cells_.reserve(positions.size());
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        if (is_finite(positions[i])) cells_.push_back({cell_of(positions[i]), i});
    std::sort(cells_.begin(), cells_.end());
}

std::size_t Neighbors::around(std::size_t i, std::span<Vec3> near) const noexcept {
    std::size_t count = 0;
    const Vec3& here = positions_[i];
    if (!is_finite(here)) return 0;
    const Cell middle = cell_of(here);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
        for (std::int64_t dy = -1; dy <= 1; ++dy) {
            // The three cells along z lie in one stretch.
            const Cell first{middle.x + dx, middle.y + dy, middle.z - 1};
            const Cell last{first.x, first.y, middle.z + 1};
            auto entry = std::lower_bound(cells_.begin(), cells_.end(), Entry{first, 0});
            for (; entry != cells_.end() && entry->cell <= last && count < near.size(); ++entry) {
                const Vec3& other = positions_[entry->index];
                if (entry->index != i && distance(here, other) < reach_) near[count++] = other;
            }
        }
    return count;
}

}  // namespace orbweaver::spider
