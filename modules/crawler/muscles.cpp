#include "muscles.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::crawler {

void Muscles::lengths(std::span<const Flex> flexes, std::span<double> rest) noexcept {
    for (std::uint32_t ring = 0; ring < half_.size(); ++ring) {
        const double before = flexes[ring > 0 ? ring - 1 : 0].strain;
        const double after = flexes[std::min<std::size_t>(ring, flexes.size() - 1)].strain;
        const double stretch = build_.keeps_volume ? 1 + (before + after) / 2 : 1;
        half_[ring] = build_.width / 2 / std::sqrt(stretch);
    }
    double* to = rest.data();
    for (std::uint32_t ring = 0; ring < half_.size(); ++ring) {
        set_ring(ring, to);
        to += Lattice::kRingSprings;
        if (ring == flexes.size()) break;
        set_segment(ring, flexes[ring], to);
        to += Lattice::kSegmentSprings;
    }
}

void Muscles::set_ring(std::uint32_t ring, double* rest) const noexcept {
    constexpr double kDiagonal = 1.4142135623730951;
    const double edge = 2 * half_[ring];
    for (std::uint32_t j = 0; j < kCorners; ++j) rest[j] = edge;
    for (std::uint32_t j = kCorners; j < Lattice::kRingSprings; ++j) rest[j] = kDiagonal * edge;
}

// Both rings turn by half of the bend, so that what lies between corner j of one and k of the other is longer
// by how far they are on the outside, on average.
void Muscles::set_segment(std::uint32_t segment, const Flex& flex, double* rest) const noexcept {
    const double a = 2 * half_[segment], b = 2 * half_[segment + 1];
    const double middle = build_.segment() * (1 + flex.strain);
    const double side = build_.segment() * flex.side / 2, up = build_.segment() * flex.up / 2;
    const auto length = [&](std::uint32_t j, std::uint32_t k) {
        const double right_a = a * kRight[j], right_b = b * kRight[k], up_a = a * kUp[j], up_b = b * kUp[k];
        const double along = middle + side * (right_a + right_b) - up * (up_a + up_b);
        const double to_right = right_b - right_a, to_up = up_b - up_a;
        return std::sqrt(along * along + to_right * to_right + to_up * to_up);
    };
    for (std::uint32_t j = 0; j < kCorners; ++j) {
        const std::uint32_t next = (j + 1) % kCorners;
        rest[j] = length(j, j);
        rest[kCorners + j] = length(j, next);
        rest[2 * kCorners + j] = length(next, j);
    }
}

}  // namespace orbweaver::crawler
