#pragma once

#include "creature.hpp"
#include "creatures.hpp"
#include "land.hpp"
#include "walking.hpp"

/// A huntsman that walks on a mesh of ours, on and on until a test has seen enough.
namespace walker {

using namespace orbweaver;
using namespace orbweaver::spider;

using spider::test::kFrame;

/// Wants nothing but what a test adds, at 0.15 m/s, and never rests.
inline Conduct purposeful() {
    Conduct conduct = spider::test::walking(spider::test::huntsman());
    conduct.pace = {0.15, 0.01, 0.027, 0.75, 0.62};
    conduct.wander = {1.2, 0.3, 10};
    conduct.rests = false;
    conduct.behaviors.wander = 0;
    conduct.gravity = {0, -9.81, 0};
    return conduct;
}

inline SurfacePoint spot(const land::Land& land, const Vec3& point) {
    return land.surface().closest_point(point, 10).at;
}

struct Walker {
    const land::Land& land;
    Conduct conduct;
    RandomStream random{1, "walker"};
    CreatureState state{};
    CreatureMeasures measures{};

    Walker(const land::Land& on, Conduct wants, const Vec3& place, const Vec3& up, const Vec3& forward)
        : land(on), conduct(std::move(wants)) {
        place_creature(land.surface(), conduct, land.stand(place, up, forward), state);
    }

    const Vec3& position() const { return state.ground.footing.position; }
    double speed() const { return norm(state.ground.velocity); }

    void step(const std::optional<Command>& command = {}, const std::optional<Agent>& quarry = {},
              const std::optional<Agent>& hunter = {}) {
        advance_creature(land.surface(), conduct, {random, {}, quarry, hunter, command}, kFrame, state,
                         measures);
    }
    void walk(double seconds, const std::optional<Command>& command = {}) {
        for (int i = 0; i < std::lround(seconds / kFrame); ++i) step(command);
    }
};

}  // namespace walker
