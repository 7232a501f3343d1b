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
    explicit LegWays(const Species& species);

    std::size_t limbs() const noexcept override { return legs_.size(); }
    std::span<const Named> ways() const noexcept override;
    std::span<const Named> kinds() const noexcept override;
    std::size_t count(std::size_t) const noexcept override { return legs_.size() * FootPaths::kTimes; }
    void reach(std::size_t way, std::size_t kind, const Effort& effort, std::span<Reach> reaches) override;

private:
    struct Asked;

    void one_by_one(const Asked& asked, const LegSolver& solver, std::span<Reach> reaches) const;
    void in_lanes(const Asked& asked, std::span<Reach> reaches) const;
    const FootPaths& paths(std::size_t kind);

    std::vector<Leg> legs_;
    std::vector<std::unique_ptr<FootPaths>> paths_;  ///< one a kind, or not made yet
};

}  // namespace orbweaver::spider
