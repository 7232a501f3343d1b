// Wandering over scanned and modelled meshes: noise, thin ears, creases and borders that shapes of our own
// lack.

#include <string>

#include "land.hpp"
#include "real_mesh.hpp"
#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

TEST_CASE("a huntsman wanders over real meshes and keeps its feet", "[extreme]") {
    constexpr int kMinutes = 2;
    constexpr std::uint64_t kSeeds = 3;
    const Conduct conduct = walking(huntsman());
    for (const std::string name : {"stanford-bunny", "spot", "fandisk", "suzanne"}) {
        const Land land(real_mesh(name, 0.5));
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
            INFO(name << ", " << seed);
            check_walk(wandered(land, conduct, seed, {0, 1, 0}, kMinutes), conduct);
        }
    }
}
