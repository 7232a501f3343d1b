#include "gait.hpp"

#include <algorithm>
#include <array>

#include "species.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kStands = -1;
constexpr double kDue = -2;  // stands, and has missed its start

/// Into [0, 1).
double wrapped(double phase) noexcept {
    const double whole = static_cast<double>(static_cast<std::int64_t>(phase));
    const double rest = phase - whole;
    const double up = rest < 0 ? rest + 1 : rest;
    return up < 1 ? up : 0;  // a rest of -1e-20 comes to 1
}

/// From `from` to `to`, the shorter way round: in [-1/2, 1/2).
double turn_between(double from, double to) noexcept { return wrapped(to - from + 0.5) - 0.5; }

bool neighbors_stand(const GaitState& state, std::size_t leg) noexcept {
    const auto stands = [&](std::size_t other) {
        return other >= state.progress.size() || state.progress[other] < 0;
    };
    const bool ahead = leg < 2 || stands(leg - 2);
    return ahead && stands(leg + 2) && stands(leg ^ 1U);
}

/// m, `later` s from now, of the feet that stand but one.
double margin_without(const GaitState& state, const GaitTick& tick, std::size_t leg, double later) noexcept {
    std::array<SupportPoint, kMaxLegs> feet;
    std::size_t count = 0;
    for (std::size_t i = 0; i < tick.feet.size(); ++i)
        if (i != leg && state.progress[i] < 0)
            feet[count++] = {tick.feet[i].forward - later * tick.velocity.forward,
                             tick.feet[i].right - later * tick.velocity.right};
    return support_of(std::span(feet).first(count)).margin;
}

/// Whether the creature stays in balance without that leg; where it is out of it, whether that gets no worse.
bool keeps_balance(const GaitState& state, const GaitTick& tick, std::size_t leg, double swing_time) noexcept {
    if (tick.feet.empty()) return true;
    const auto bears = [&](double later) {
        const double margin = margin_without(state, tick, leg, later);
        return margin >= 0 || margin >= margin_without(state, tick, tick.feet.size(), later);
    };
    return bears(0) && bears(swing_time);
}

}  // namespace

std::span<const Gait> gaits() noexcept {
    static constexpr std::array<Gait, 3> table{{
        // The last of a set lifts 0.12 of a cycle after the first: at a duty of 0.62 and more, a set is down
        // again before the other lifts.
        {"tetrapod", 0.54, 0.5},
        {"ripple", 0.25, 0.5},
        {"wave", 0.125, 0.5},
    }};
    return table;
}

const Gait* find_gait(std::string_view name) noexcept {
    const auto all = gaits();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Gait& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

double start_of(const Gait& gait, std::size_t leg, std::size_t legs) noexcept {
    const std::size_t pairs_behind = (legs - 1) / 2 - leg / 2;
    return wrapped(gait.lag * static_cast<double>(pairs_behind) + (leg % 2 == 1 ? gait.opposite : 0));
}

Pace pace_at(const PaceRange& range, double speed) noexcept {
    const double share = range.top_speed > 0 ? std::clamp(speed / range.top_speed, 0.0, 1.0) : 0;
    Pace pace;
    pace.stride = range.shortest_stride + share * (range.longest_stride - range.shortest_stride);
    pace.frequency = pace.stride > 0 ? share * range.top_speed / pace.stride : 0;
    pace.duty = range.slow_duty + share * (range.fast_duty - range.slow_duty);
    return pace;
}

void begin_gait(const Gait& gait, const GaitState& state) noexcept {
    *state.phase = 0;
    for (std::size_t leg = 0; leg < state.start.size(); ++leg) {
        state.start[leg] = start_of(gait, leg, state.start.size());
        state.progress[leg] = kStands;
    }
}

void advance_gait(const Gait& gait, const Pace& pace, const GaitTick& tick, const GaitState& state) noexcept {
    const std::size_t legs = state.start.size();
    const double cycles = pace.frequency * tick.dt;
    const double before = *state.phase;
    *state.phase = wrapped(before + cycles);
    const double swing = 1 - pace.duty;  // of a cycle
    const double rate = std::max(swing > 0 ? pace.frequency / swing : 0, 1 / tick.landing_time);
    auto standing = static_cast<std::size_t>(
        std::count_if(state.progress.begin(), state.progress.end(), [](double each) { return each < 0; }));
    for (std::size_t leg = 0; leg < legs; ++leg) {
        const double most = tick.turn_rate * tick.dt;
        const double off = tick.jitter.empty() ? 0 : tick.jitter[leg];
        const double turn =
            std::clamp(turn_between(state.start[leg], start_of(gait, leg, legs) + off), -most, most);
        state.start[leg] = wrapped(state.start[leg] + turn);
        tick.lifted[leg] = tick.landed[leg] = 0;
        if (motion_of(state, leg) == LegMotion::swings) {
            state.progress[leg] += rate * tick.dt;
            if (state.progress[leg] < 1) continue;
            state.progress[leg] = kStands;
            tick.landed[leg] = 1;
            continue;
        }
        // What is left of the frame since the leg's start came, in cycles; turning counts as waiting.
        const double since = wrapped(before - state.start[leg]) + cycles - turn - 1;
        const bool comes = cycles > 0 && since >= 0;
        const bool due = comes || state.progress[leg] == kDue;
        const bool strained = tick.strained[leg] != 0 && neighbors_stand(state, leg);
        if (!due && !strained) continue;
        if (2 * (standing - 1) < legs || (!strained && !keeps_balance(state, tick, leg, 1 / rate))) {
            if (due) state.progress[leg] = kDue;
            continue;
        }
        --standing;
        state.progress[leg] = comes && pace.frequency > 0 ? std::min(rate * since / pace.frequency, 0.999) : 0;
        tick.lifted[leg] = 1;
    }
}

}  // namespace orbweaver::spider
