#include "backbone.hpp"

#include <cmath>

#include "pauses.hpp"
#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

/// On a floor, all feet down where they are at rest; those of the front half raised by `raised` m.
CreatureState standing(const Species& species, double raised) {
    CreatureState state;
    state.ground.footing.up = state.turn.up = {0, 1, 0};
    state.ground.footing.forward = state.ground.facing = {1, 0, 0};
    const Conduct conduct = walking(species);
    const BodyPose body = pose_of(conduct, state);
    for (std::size_t leg = 0; leg < species.limbs.size(); ++leg) {
        state.progress[leg] = -1;
        state.feet[leg].holds = true;
        state.feet[leg].place = to_world(body, species.limbs[leg].home);
        if (leg < species.limbs.size() / 2) state.feet[leg].place.y += raised;
    }
    return state;
}

/// m, along the body, from the mean of the back half's feet to the front half's.
double base_of(const Species& species) {
    double front = 0, back = 0;
    for (std::size_t leg = 0; leg < 4; ++leg) front += species.limbs[leg].home.x / 4;
    for (std::size_t leg = 4; leg < 8; ++leg) back += species.limbs[leg].home.x / 4;
    return front - back;
}

}  // namespace

TEST_CASE("the abdomen lies along the line from the front feet to the back ones, as far as it bends",
          "[unit]") {
    const Species species = creature("huntsman");
    const Conduct conduct = walking(species);
    // Not quite level: feet at rest are at one height within 1 %.
    CHECK(std::abs(wanted_bend(conduct, standing(species, 0))) < 0.01);
    const double level = std::tan(wanted_bend(conduct, standing(species, 0)));
    for (const double raised : {-8e-3, -3e-3, 2e-3, 6e-3})
        CHECK(std::tan(wanted_bend(conduct, standing(species, raised))) ==
              Approx(level - raised / base_of(species)));
    CHECK(wanted_bend(conduct, standing(species, 6e-3)) < 0);  // front feet higher: it hangs
    CHECK(wanted_bend(conduct, standing(species, 0.1)) == species.body.bend_min);
    CHECK(wanted_bend(conduct, standing(species, -0.1)) == species.body.bend_max);
}

TEST_CASE("feet in the air have no say in the bend, and without any it is straight", "[unit]") {
    const Species species = creature("huntsman");
    const Conduct conduct = walking(species);
    CreatureState state = standing(species, 2e-3);
    const double all = wanted_bend(conduct, state);
    state.feet[0].place.y += 0.02;
    CHECK(wanted_bend(conduct, state) < all);
    state.progress[0] = 0.5;
    state.feet[1].place.y += 0.02;
    state.feet[1].holds = false;
    CHECK(wanted_bend(conduct, state) > -0.3);
    for (std::size_t leg = 0; leg < 4; ++leg) state.progress[leg] = 0.5;
    CHECK(wanted_bend(conduct, state) == 0);
}

TEST_CASE("a species whose back does not bend keeps it straight", "[unit]") {
    const Species species = creature("harvestman");
    CHECK(wanted_bend(walking(species), standing(species, 0.01)) == 0);
}

TEST_CASE("the back bends no faster than it may, and comes to what is wanted", "[unit]") {
    const Species species = creature("huntsman");
    Conduct conduct = walking(species);
    conduct.turn_rate = 60;
    CreatureState state = standing(species, -0.1);
    const double most = 60 * kDegree * kFrame;
    for (int i = 0; i < 240; ++i) {
        const double before = state.bend;
        bend_back(conduct, kFrame, state);
        CHECK(state.bend >= before);
        CHECK(state.bend - before <= most * (1 + 1e-12));
        if (i == 0) CHECK(state.bend == Approx(most));
    }
    CHECK(state.bend == Approx(species.body.bend_max).epsilon(1e-6));
}

TEST_CASE("a huntsman that walks over a cube's edges bends both ways, within its limits", "[unit]") {
    const Species species = creature("huntsman");
    const Conduct conduct = walking(species);
    const Land land(mesh::cube(0.3, 4));
    const RandomStream random(1, "bends");
    CreatureState state;
    CreatureMeasures measures;
    place_creature(land.surface(), conduct, land.stand({0.1, 0.15, 0}, {0, 1, 0}, {1, 0, 0.3}), state);
    double least = 0, most = 0;
    for (int i = 0; i < 3600; ++i) {
        const double before = state.bend;
        advance_creature(land.surface(), conduct, {random, {}}, kFrame, state, measures);
        CHECK(std::abs(state.bend - before) <= conduct.turn_rate * kDegree * kFrame * (1 + 1e-12));
        least = std::min(least, state.bend);
        most = std::max(most, state.bend);
    }
    CHECK(least < -5 * kDegree);
    CHECK(most > 5 * kDegree);
    CHECK(least >= species.body.bend_min);
    CHECK(most <= species.body.bend_max);
}
