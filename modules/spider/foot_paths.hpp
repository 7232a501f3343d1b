#pragma once

#include <span>
#include <vector>

#include "leg_solver.hpp"

namespace orbweaver::spider {

/// What a creature's solvers are asked for when they are held against each other, in the legs' own frames, m:
/// feet that go round loops of a stride's shape, and places that random poses within limits reach. Of each
/// target the orientation is that of a pose which reaches it.
class FootPaths {
public:
    static constexpr std::size_t kTimes = 256;  ///< targets of each leg

    /// `step`: how far a foot on its loop goes from one target to the next, leg lengths.
    FootPaths(std::span<const Leg> legs, double step);

    const std::vector<Leg>& legs() const noexcept { return legs_; }
    /// Of leg i at time t: on its loop (warm), or anywhere (cold).
    const LegTarget& at(bool cold, std::size_t i, std::size_t t) const noexcept {
        return (cold ? cold_ : warm_)[i * kTimes + t];
    }

private:
    std::vector<Leg> legs_;
    std::vector<LegTarget> warm_, cold_;
};

}  // namespace orbweaver::spider
