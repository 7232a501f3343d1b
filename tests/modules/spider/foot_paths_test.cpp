#include "foot_paths.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;

TEST_CASE("a foot on its loop goes no further than its step, and every target can be reached", "[unit]") {
    const Species species = test::creature("tarantula");
    std::vector<Leg> legs;
    for (const Limb& limb : species.limbs) legs.push_back(limb.leg);
    const FootPaths paths(legs, 0.01);
    for (std::size_t i = 0; i < legs.size(); ++i) {
        double farthest = 0;
        for (std::size_t t = 0; t < FootPaths::kTimes; ++t) {
            for (const bool cold : {false, true}) CHECK(norm(paths.at(cold, i, t).position) <= legs[i].length);
            if (t == 0) continue;
            const double step = distance(paths.at(false, i, t).position, paths.at(false, i, t - 1).position);
            CHECK(step <=
                  0.01 * legs[i].length * (1 + 1e-3));  // targets are a solver's, within 1e-6 of the loop
            farthest = std::max(farthest, step);
        }
        CHECK(farthest > 0.009 * legs[i].length);
    }
}
