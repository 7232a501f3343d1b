#include <algorithm>
#include <limits>
#include <set>

#include "construction.hpp"

namespace orbweaver::web {

namespace {

constexpr double kShortest = 0.1;  // of the spokes' placement: shorter pieces are not laid

/// Lays spiral thread from spoke to spoke and keeps the account of what is covered.
class SpiralWalk {
public:
    SpiralWalk(const Construction& how, Layout& layout)
        : layout_(layout), shortest_(kShortest * how.spokes.placement), covered_(layout.positions.size(), 0) {
        for (const auto& spoke : layout.spokes) masses_.push_back(usable_masses(how, spoke));
    }

    std::size_t spokes() const { return masses_.size(); }
    std::size_t masses(std::size_t spoke) const { return masses_[spoke].size(); }
    bool covered(std::size_t spoke, std::size_t mass) const { return covered_[masses_[spoke][mass]] != 0; }
    std::size_t uncovered(std::size_t spoke) const {
        const auto& masses = masses_[spoke];
        return static_cast<std::size_t>(
            std::count_if(masses.begin(), masses.end(), [&](Index i) { return covered_[i] == 0; }));
    }

    /// Once around all spokes, from the given mass to one farther in on the same spoke; ends early where it
    /// meets thread that is there already, for from there it would only follow it.
    void once_around(std::size_t spoke, std::size_t mass) {
        Index from = masses_[spoke][mass];
        covered_[from] = 1;
        for (std::size_t i = 1; i <= spokes(); ++i) {
            const std::size_t next = (spoke + i) % spokes();
            const Index to = nearest(next, next == spoke ? mass + 1 : 0, from);
            if (to == kNone || !join(from, to)) return;
            covered_[to] = 1;
            from = to;
        }
    }

private:
    static constexpr Index kNone = std::numeric_limits<Index>::max();

    /// Masses the spiral may touch, from the frame inwards: neither frame nor hub, nor too near to either.
    std::vector<Index> usable_masses(const Construction& how, const std::vector<Index>& spoke) const {
        std::vector<Index> usable;
        const Vec3& frame = layout_.positions[spoke.front()];
        const Vec3& hub = layout_.positions[spoke.back()];
        for (std::size_t i = 1; i + 1 < spoke.size(); ++i) {
            const Vec3& p = layout_.positions[spoke[i]];
            if (distance(p, frame) >= how.spiral_start && distance(p, hub) >= how.spiral_end)
                usable.push_back(spoke[i]);
        }
        return usable;
    }

    Index nearest(std::size_t spoke, std::size_t first, Index from) const {
        Index best = kNone;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t m = first; m < masses_[spoke].size(); ++m) {
            const double way = distance(layout_.positions[masses_[spoke][m]], layout_.positions[from]);
            if (way >= least) continue;
            least = way;
            best = masses_[spoke][m];
        }
        return best;
    }

    bool join(Index a, Index b) {
        if (distance(layout_.positions[a], layout_.positions[b]) < shortest_) return false;
        if (!joined_.insert(std::minmax(a, b)).second) return false;
        layout_.pieces.push_back({a, b, Kind::spiral});
        return true;
    }

    Layout& layout_;
    double shortest_;
    std::vector<std::vector<Index>> masses_;  // per spoke, from the frame inwards
    std::vector<std::uint8_t> covered_;       // per particle
    std::set<std::pair<Index, Index>> joined_;
};

/// Figure 5.15: one turn from every mass of the first spoke.
void lay_initial_spiral(SpiralWalk& walk) {
    for (std::size_t mass = 0; mass < walk.masses(0); ++mass) walk.once_around(0, mass);
}

/// Figure 5.16: turns from the bare masses of the barest spoke, until none has more than the bound.
void lay_processed_spiral(SpiralWalk& walk, std::size_t bound) {
    for (;;) {
        std::size_t barest = 0;
        for (std::size_t s = 1; s < walk.spokes(); ++s)
            if (walk.uncovered(s) > walk.uncovered(barest)) barest = s;
        if (walk.uncovered(barest) <= bound) return;
        for (std::size_t mass = 0; mass < walk.masses(barest); ++mass)
            if (!walk.covered(barest, mass)) walk.once_around(barest, mass);
    }
}

}  // namespace

void lay_spiral(const Construction& how, Layout& layout) {
    SpiralWalk walk(how, layout);
    lay_initial_spiral(walk);
    lay_processed_spiral(walk, static_cast<std::size_t>(how.spiral_density));
}

}  // namespace orbweaver::web
