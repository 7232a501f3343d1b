#include "pauses.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace orbweaver;
using namespace orbweaver::spider;

TEST_CASE("walks and pauses last as long as they may, and as long on the mean as they should", "[unit]") {
    constexpr double kFrame = 1.0 / 60;
    const PauseSettings settings;
    const RandomStream random(11, "pauses");
    PauseState state;
    double lasted = 0, stood = 0;
    int pauses = 0;
    constexpr int kFrames = 600000;
    for (int i = 0; i < kFrames; ++i) {
        const bool before = state.stands;
        advance_pauses(settings, random, kFrame, state);
        lasted += kFrame;
        stood += state.stands ? kFrame : 0;
        if (state.stands == before) continue;
        const double least = before ? settings.pause_least : settings.walk_least;
        const double most = before ? settings.pause_most : settings.walk_most;
        CHECK(lasted > least - 2 * kFrame);
        CHECK(lasted < most + 2 * kFrame);
        lasted = 0;
        pauses += state.stands ? 1 : 0;
    }
    CHECK(pauses > 1000);
    // Means of 5 s and 1.75 s; 1500 of each leave 1 % of chance.
    CHECK(stood / (kFrames * kFrame) == Approx(1.75 / 6.75).epsilon(0.05));
}

TEST_CASE("palps twitch while the creature stands, and hang still while it walks", "[unit]") {
    const PauseSettings settings;
    PauseState state;
    CHECK(twitch(settings, state, true) == 0);
    state.stands = true;
    double most = 0, apart = 0;
    for (int i = 0; i < 1000; ++i) {
        state.stood = i * 1e-3;
        most = std::max(most, std::abs(twitch(settings, state, false)));
        apart = std::max(apart, std::abs(twitch(settings, state, false) - twitch(settings, state, true)));
    }
    CHECK(most > 0.8);
    CHECK(most <= 1);
    CHECK(apart > 0.5);
    state.stood = 0;
    CHECK(twitch(settings, state, true) == 0);
}
