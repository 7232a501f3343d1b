#pragma once

#include <memory>
#include <vector>

#include "foot_paths.hpp"
#include "leg_lanes.hpp"
#include "orbweaver/contracts/reach_ways.hpp"
#include "species.hpp"

namespace orbweaver::spider {

/// The solvers of legs, and the lanes that run eight legs at once, as ways of reaching. Targets are made when
/// one is first asked for.
class LegWays final : public ReachWays {
public:
    /// `species` outlives it.
    explicit LegWays(const Species& species) noexcept : species_(species) {}
    explicit LegWays(const Species&&) = delete;

    std::size_t limbs() const noexcept override { return species_.limbs.size(); }
    std::span<const Named> ways() const noexcept override;
    std::span<const Named> kinds() const noexcept override;
    std::size_t count(std::size_t) const noexcept override { return limbs() * FootPaths::kTimes; }
    void reach(std::size_t way, std::size_t kind, const Effort& effort, std::span<Reach> reaches) override;

private:
    const FootPaths& paths(std::size_t kind);

    const Species& species_;
    std::vector<std::unique_ptr<FootPaths>> paths_;  ///< one a kind, or not made yet
};

}  // namespace orbweaver::spider
