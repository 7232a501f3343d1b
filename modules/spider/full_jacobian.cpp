#include <algorithm>

#include "comfort.hpp"
#include "definite_system.hpp"
#include "half_jacobian.hpp"
#include "restarts.hpp"
#include "solvers.hpp"

namespace orbweaver::spider {

namespace {

using Vector = Triple<double>;

/// Place and orientation, in the plane's frame: leg lengths, and radians that count as much.
struct TipError {
    Vector place, turn;

    double squared() const noexcept { return dot(place, place) + dot(turn, turn); }
};

Vector triple(const Vec3& v) noexcept { return {v.x, v.y, v.z}; }

/// The turn that takes a frame to another, as 2 sin(angle / 2) times its axis: like the angle when small, and
/// largest at half a turn, where sin(angle), which the cross products give, is lost again.
Vector turn_between(const std::array<Vector, 3>& from, const std::array<Vector, 3>& to) noexcept {
    Vector turn{};
    double trace = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector &a = from[k], &b = to[k];
        turn.x += 0.5 * (a.y * b.z - a.z * b.y);
        turn.y += 0.5 * (a.z * b.x - a.x * b.z);
        turn.z += 0.5 * (a.x * b.y - a.y * b.x);
        trace += dot(a, b);
    }
    const double half_cosine = sqrt(larger(0.25 * (1 + trace), 1e-6));
    return {turn.x / half_cosine, turn.y / half_cosine, turn.z / half_cosine};
}

TipError error_of(const Posture<double>& at, const Vec3& place, const Frame& orientation) noexcept {
    const Vector aim = to_plane(at, triple(place));
    const Rotor<double>& tip = at.along[kBones - 1];
    const std::array<Vector, 3> from{{{tip.c, tip.s, 0}, {-tip.s, tip.c, 0}, {0, 0, 1}}};
    const std::array<Vector, 3> to{to_plane(at, triple(orientation.x)), to_plane(at, triple(orientation.y)),
                                   to_plane(at, triple(orientation.z))};
    return {{aim.x - at.x[kBones], aim.y - at.y[kBones], aim.z}, turn_between(from, to)};
}

/// As half_jacobian_turns(), with three rows more.
void full_jacobian_turns(const Leg& leg, const Posture<double>& at, const double (&pose)[kJoints],
                         const TipError& error, const double (&wish)[kJoints],
                         double (&turns)[kJoints]) noexcept {
    double b[6] = {error.place.x, error.place.y, error.place.z, error.turn.x, error.turn.y, error.turn.z};
    double a[6][6] = {};
    double column[kJoints][6], weight[kJoints];
    const double damping = 0.5 * error.squared() + kLeastDamping;
    for (std::size_t j = 0; j < kJoints; ++j) {
        const Vector move = foot_velocity(at, j), axis = joint_axis(at, j);
        const double rows[6] = {move.x, move.y, move.z, axis.x, axis.y, axis.z};
        std::copy(std::begin(rows), std::end(rows), column[j]);
        weight[j] = compliance(leg, j, pose[j], dot(move, error.place) + dot(axis, error.turn));
        for (std::size_t r = 0; r < 6; ++r)
            for (std::size_t c = 0; c <= r; ++c) a[r][c] += weight[j] * rows[r] * rows[c];
    }
    for (std::size_t r = 0; r < 6; ++r) {
        a[r][r] += damping;
        for (std::size_t j = 0; j < kJoints; ++j) b[r] -= column[j][r] * wish[j];
    }
    solve_definite(a, b);
    for (std::size_t j = 0; j < kJoints; ++j) {
        turns[j] = wish[j];
        for (std::size_t r = 0; r < 6; ++r) turns[j] += weight[j] * column[j][r] * b[r];
    }
}

Approach<double> full_jacobian_approach(const Leg& leg, const Vec3& place, const Frame& orientation,
                                        const LegSolverOptions& options, LegPose& pose) noexcept {
    const double enough = options.tolerance * options.tolerance;
    double angles[kJoints], wish[kJoints], turns[kJoints];
    std::copy(pose.begin(), pose.end(), angles);
    for (std::size_t j = 0; j < kJoints; ++j)
        wish[j] = comfort_wish(leg, j, angles[j], options.comfort, options.rest);
    Approach<double> approach{1e300, 0};
    int little_gains = 0;
    for (int step = 0;; ++step) {
        const Posture<double> at = posture(leg, angles);
        const TipError error = error_of(at, place, orientation);
        const double squared = error.squared();
        little_gains = squared > kLittleGain * approach.squared_error ? little_gains + 1 : 0;
        approach.squared_error = squared;
        const bool done = step > 0 && (squared <= enough || little_gains >= kLittleGains);
        if (done || step == options.max_steps) break;
        full_jacobian_turns(leg, at, angles, error, wish, turns);
        turn_joints(leg, options.max_turn, true, turns, angles);
        approach.steps += 1;
        std::fill(std::begin(wish), std::end(wish), 0.0);
    }
    std::copy(std::begin(angles), std::end(angles), pose.begin());
    return approach;
}

bool finite(const Frame& f) noexcept { return is_finite(f.x) && is_finite(f.y) && is_finite(f.z); }

}  // namespace

LegResult solve_full_jacobian(const Leg& leg, const LegTarget& target, const LegSolverOptions& options,
                              LegPose& pose) {
    if (!finite(target.orientation)) return {};
    const auto approach = [&](const Vec3& at, LegPose& from) {
        return full_jacobian_approach(leg, at, target.orientation, options, from);
    };
    return solve_with_restarts(leg, target, options, approach, pose);
}

}  // namespace orbweaver::spider
