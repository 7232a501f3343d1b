// Wandering over scanned and modelled meshes: noise, thin ears, creases and borders that shapes of our own
// lack.

#include <algorithm>
#include <string>

#include "../surface/obj_mesh.hpp"
#include "land.hpp"
#include "walking.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

/// Its middle at the origin, its largest extent as given (m).
mesh::RawMesh real_mesh(const std::string& name, double size) {
    const mesh::RawMesh raw = surface::test::read_obj(std::string(ORBWEAVER_MESHES) + "/" + name + ".obj");
    Vec3 low = raw.points[0], high = low;
    for (const Vec3& p : raw.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 extent = high - low;
    const double scale = size / std::max({extent.x, extent.y, extent.z});
    return mesh::transformed(raw, scale, -0.5 * scale * (low + high));
}

}  // namespace

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
