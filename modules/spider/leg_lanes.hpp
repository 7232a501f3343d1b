#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "leg_solver.hpp"
#include "real.hpp"

namespace orbweaver::spider {

inline constexpr std::size_t kLanes = 8;  ///< a spider's legs

/// Constants of eight legs, for kernels of either width.
struct LaneBlock {
    Chain<Lanes8> all;
    Chain<Lanes4> halves[2];
};

/// Where the searches of eight legs ended. Numbers, so that lanes can write them.
struct LaneEnds {
    double squared_error[kLanes];  ///< leg lengths squared
    double steps[kLanes];
    double finite[kLanes];  ///< 1 or 0: the target was
    double beyond[kLanes];  ///< 1 or 0: the target was out of reach
};

/// Eight legs towards eight targets (m; all x, all y, all z) from and to `angles` (joint by joint), without
/// restarts.
struct LaneKernel {
    const char* name;
    void (*run)(const LaneBlock& legs, const double* targets, const LegSolverOptions& options, double* angles,
                LaneEnds& ends) noexcept;
};

/// Those that this processor can run, the fastest last: plain, avx2, avx512. They give the same bits.
std::span<const LaneKernel> lane_kernels() noexcept;

/// The half Jacobian for many legs, eight side by side, with the bits of solving one after another. Constant:
/// angles and targets are the caller's, so that all creatures of a species share it.
class LegLanes {
public:
    /// At least one leg.
    explicit LegLanes(std::span<const Leg> legs, const LaneKernel& kernel = lane_kernels().back());

    std::size_t size() const noexcept { return legs_.size(); }
    const Leg& leg(std::size_t i) const noexcept { return legs_[i]; }

    /// How many doubles `angles` and `targets` hold, and where those of leg i are.
    std::size_t angle_count() const noexcept { return blocks_.size() * kJoints * kLanes; }
    std::size_t target_count() const noexcept { return blocks_.size() * 3 * kLanes; }
    LegPose pose(std::span<const double> angles, std::size_t i) const noexcept;
    void set_pose(std::span<double> angles, std::size_t i, const LegPose& pose) const noexcept;
    /// m, in the leg's own frame.
    Vec3 target(std::span<const double> targets, std::size_t i) const noexcept;
    void set_target(std::span<double> targets, std::size_t i, const Vec3& position) const noexcept;

    /// As SolveLeg does for each leg; results[i] is of leg i. Allocates nothing.
    void solve(std::span<const double> targets, const LegSolverOptions& options, std::span<double> angles,
               std::span<LegResult> results) const noexcept;

private:
    LegResult finish(const LaneEnds& ends, std::size_t i, std::span<const double> targets,
                     const LegSolverOptions& options, std::span<double> angles) const noexcept;

    std::vector<Leg> legs_;
    std::vector<LaneBlock> blocks_;  ///< filled up with the last leg
    LaneKernel kernel_;
};

}  // namespace orbweaver::spider
