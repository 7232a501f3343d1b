#include "leg_lanes.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "half_jacobian.hpp"
#include "restarts.hpp"

namespace orbweaver::spider {

namespace {

/// The legs of a block from `first` on, as many as a Real has lanes.
template <class Real>
ORBWEAVER_INLINE void solve_lanes(const Chain<Real>& legs, std::size_t first, const double* targets,
                                  const LegSolverOptions& options, double* angles, LaneEnds& ends) noexcept {
    const double* at = targets + first;
    const Aim<Real> aim =
        aim_at(legs, Triple<Real>{load<Real>(at), load<Real>(at + kLanes), load<Real>(at + 2 * kLanes)});
    Real pose[kJoints];
    for (std::size_t j = 0; j < kJoints; ++j) pose[j] = load<Real>(angles + first + j * kLanes);
    const Approach<Real> end = half_jacobian_approach(legs, aim.at, options, aim.finite, pose);
    for (std::size_t j = 0; j < kJoints; ++j) store(angles + first + j * kLanes, pose[j]);
    const Real zero{}, one = zero + 1;
    store(ends.squared_error + first, end.squared_error);
    store(ends.steps + first, end.steps);
    store(ends.finite + first, select(aim.finite, one, zero));
    store(ends.beyond + first, select(aim.beyond, one, zero));
}

void plain(const LaneBlock& legs, const double* targets, const LegSolverOptions& options, double* angles,
           LaneEnds& ends) noexcept {
    for (const std::size_t half : {0, 1})
        solve_lanes(legs.halves[half], 4 * half, targets, options, angles, ends);
}

ORBWEAVER_AVX2 void avx2(const LaneBlock& legs, const double* targets, const LegSolverOptions& options,
                         double* angles, LaneEnds& ends) noexcept {
    for (const std::size_t half : {0, 1})
        solve_lanes(legs.halves[half], 4 * half, targets, options, angles, ends);
}

ORBWEAVER_AVX512 void avx512(const LaneBlock& legs, const double* targets, const LegSolverOptions& options,
                             double* angles, LaneEnds& ends) noexcept {
    solve_lanes(legs.all, 0, targets, options, angles, ends);
}

template <class Lanes>
void set_lane(Chain<Lanes>& legs, std::size_t lane, const Leg& leg) noexcept {
    // Both are nothing but Reals, one after another.
    constexpr std::size_t count = sizeof(Leg) / sizeof(double);
    static_assert(sizeof(Chain<Lanes>) == count * sizeof(Lanes));
    const auto* from = reinterpret_cast<const std::byte*>(&leg);
    auto* to = reinterpret_cast<std::byte*>(&legs) + lane * sizeof(double);
    for (std::size_t k = 0; k < count; ++k)
        std::memcpy(to + k * sizeof(Lanes), from + k * sizeof(double), sizeof(double));
}

/// Of leg i's number `row`, where each block holds `rows` of each leg.
std::size_t place(std::size_t i, std::size_t row, std::size_t rows) noexcept {
    return (i / kLanes * rows + row) * kLanes + i % kLanes;
}

}  // namespace

std::span<const LaneKernel> lane_kernels() noexcept {
    static constexpr std::array<LaneKernel, 3> all{{{"plain", plain}, {"avx2", avx2}, {"avx512", avx512}}};
    const std::size_t count = has_avx512() ? 3 : has_avx2() ? 2 : 1;
    return std::span(all).first(count);
}

LegLanes::LegLanes(std::span<const Leg> legs, const LaneKernel& kernel)
    : legs_(legs.begin(), legs.end()), blocks_((legs.size() + kLanes - 1) / kLanes), kernel_(kernel) {
    for (std::size_t i = 0; i < kLanes * blocks_.size(); ++i) {
        LaneBlock& block = blocks_[i / kLanes];
        const Leg& leg = legs_[std::min(i, legs_.size() - 1)];
        set_lane(block.all, i % kLanes, leg);
        set_lane(block.halves[i % kLanes / 4], i % 4, leg);
    }
}

LegPose LegLanes::pose(std::span<const double> angles, std::size_t i) const noexcept {
    LegPose pose;
    for (std::size_t j = 0; j < kJoints; ++j) pose[j] = angles[place(i, j, kJoints)];
    return pose;
}

void LegLanes::set_pose(std::span<double> angles, std::size_t i, const LegPose& pose) const noexcept {
    for (std::size_t j = 0; j < kJoints; ++j) angles[place(i, j, kJoints)] = pose[j];
}

Vec3 LegLanes::target(std::span<const double> targets, std::size_t i) const noexcept {
    return {targets[place(i, 0, 3)], targets[place(i, 1, 3)], targets[place(i, 2, 3)]};
}

void LegLanes::set_target(std::span<double> targets, std::size_t i, const Vec3& position) const noexcept {
    targets[place(i, 0, 3)] = position.x;
    targets[place(i, 1, 3)] = position.y;
    targets[place(i, 2, 3)] = position.z;
}

LegResult LegLanes::finish(const LaneEnds& ends, std::size_t i, std::span<const double> targets,
                           const LegSolverOptions& options, std::span<double> angles) const noexcept {
    const std::size_t lane = i % kLanes;
    if (ends.finite[lane] == 0) return {};
    BestPose best{{}, ends.squared_error[lane], static_cast<int>(ends.steps[lane])};
    const bool beyond = ends.beyond[lane] != 0;
    if (!beyond && !(best.squared_error <= options.tolerance * options.tolerance)) {
        const Leg& leg = legs_[i];
        const Vec3 aim = leg_lengths(leg, target(targets, i));
        best.pose = pose(angles, i);
        const auto approach = [&](LegPose& start) {
            return approach_by_half_jacobian(leg, aim, options, start);
        };
        restart(leg, aim, options, approach, best);
        set_pose(angles, i, best.pose);
    }
    return result_of(legs_[i], best, beyond, options.tolerance);
}

void LegLanes::solve(std::span<const double> targets, const LegSolverOptions& options, std::span<double> angles,
                     std::span<LegResult> results) const noexcept {
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        LaneEnds ends;
        kernel_.run(blocks_[b], &targets[place(b * kLanes, 0, 3)], options,
                    &angles[place(b * kLanes, 0, kJoints)], ends);
        for (std::size_t i = b * kLanes; i < std::min((b + 1) * kLanes, legs_.size()); ++i)
            results[i] = finish(ends, i, targets, options, angles);
    }
}

}  // namespace orbweaver::spider
