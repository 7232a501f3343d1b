#include "muscles.hpp"

#include <algorithm>
#include <cmath>

#include "mass_spring/lanes.hpp"

namespace orbweaver::crawler {

namespace {

using mass_spring::sqrt;

/// Two rings of a segment: corner j of one is joined to corner `to[j]` of the other. Both turn by half of the
/// bend, so that what lies between two corners is longer by how far they are on the outside, on average.
ORBWEAVER_INLINE Lanes lengths_between(double a, double b, double middle, double side, double up,
                                       const std::array<std::uint32_t, kCorners>& from,
                                       const std::array<std::uint32_t, kCorners>& to) noexcept {
    Lanes right_a, up_a, right_b, up_b;
    for (std::uint32_t j = 0; j < kCorners; ++j) {
        right_a[j] = kRight[from[j]], up_a[j] = kUp[from[j]];
        right_b[j] = kRight[to[j]], up_b[j] = kUp[to[j]];
    }
    right_a *= a, up_a *= a, right_b *= b, up_b *= b;
    const Lanes along = middle + side * (right_a + right_b) - up * (up_a + up_b);
    const Lanes to_right = right_b - right_a, to_up = up_b - up_a;
    return sqrt(along * along + to_right * to_right + to_up * to_up);
}

ORBWEAVER_INLINE void set_ring(double edge, double* rest) noexcept {
    constexpr double kDiagonal = 1.4142135623730951;
    store(rest, in_all(edge));
    for (std::uint32_t j = kCorners; j < Lattice::kRingSprings; ++j) rest[j] = kDiagonal * edge;
}

ORBWEAVER_INLINE void set_segment(double a, double b, double length, const Flex& flex, double* rest) noexcept {
    constexpr std::array<std::uint32_t, kCorners> kSame{0, 1, 2, 3}, kNext{1, 2, 3, 0};
    const double middle = length * (1 + flex.strain), side = length * flex.side / 2, up = length * flex.up / 2;
    store(rest, lengths_between(a, b, middle, side, up, kSame, kSame));
    store(rest + kCorners, lengths_between(a, b, middle, side, up, kSame, kNext));
    store(rest + std::size_t{2} * kCorners, lengths_between(a, b, middle, side, up, kNext, kSame));
}

}  // namespace

Muscles::Muscles(const Build& build) : build_(build), edges_(build.segments + 1, build.width) {}

void Muscles::lengths(std::span<const Flex> flexes, std::span<double> rest) noexcept {
    for (std::size_t ring = 0; build_.keeps_volume && ring < edges_.size(); ++ring) {
        const double before = flexes[ring > 0 ? ring - 1 : 0].strain;
        const double after = flexes[std::min(ring, flexes.size() - 1)].strain;
        edges_[ring] = build_.width / std::sqrt(1 + (before + after) / 2);
    }
    run_wide([this, flexes, rest]() ORBWEAVER_ALWAYS_INLINE {
        double* to = rest.data();
        for (std::size_t ring = 0; ring < flexes.size(); ++ring) {
            set_ring(edges_[ring], to);
            set_segment(edges_[ring], edges_[ring + 1], build_.segment(), flexes[ring],
                        to + Lattice::kRingSprings);
            to += Lattice::kRingSprings + Lattice::kSegmentSprings;
        }
        set_ring(edges_.back(), to);
    });
}

}  // namespace orbweaver::crawler
