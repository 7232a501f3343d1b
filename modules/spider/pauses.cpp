#include "pauses.hpp"

#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {

void advance_pauses(const PauseSettings& settings, const RandomStream& random, double dt,
                    PauseState& state) noexcept {
    if (state.draws == 0) state.left = random.uniform(state.draws++, settings.walk_least, settings.walk_most);
    state.left -= dt;
    state.stood = state.stands ? state.stood + dt : 0;
    if (state.left > 0) return;
    state.stands = !state.stands;
    state.left += state.stands ? random.uniform(state.draws, settings.pause_least, settings.pause_most)
                               : random.uniform(state.draws, settings.walk_least, settings.walk_most);
    ++state.draws;
    state.stood = 0;
}

double twitch(const PauseSettings& settings, const PauseState& state, bool right) noexcept {
    if (!state.stands) return 0;
    constexpr double kTurn = 360, kBursts = 0.6;  // degrees, bursts a second
    const double lag = right ? 0.37 : 0;
    const double burst = sin_degrees(kTurn * kBursts * state.stood);
    return burst * sin_degrees(kTurn * (settings.twitch_rate * state.stood + lag));
}

}  // namespace orbweaver::spider
