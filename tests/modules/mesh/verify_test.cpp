#include "verify.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

TEST_CASE("every shape is sound as built, and unsound after any change", "[unit]") {
    Validation validation;
    const SurfaceMeshData sound = test::build(fan(1, 2), validation);
    CHECK_NOTHROW(verify(sound.view(), validation, "m"));
    const std::vector<std::pair<const char*, void (*)(SurfaceMeshData&, Validation&)>> cases = {
        {"triangle 4 has one corner twice",
         [](SurfaceMeshData& m, Validation&) { m.triangles[4][2] = m.triangles[4][0]; }},
        {"its polygons do not ascend", [](SurfaceMeshData& m, Validation&) { m.polygon[0] = 5; }},
        {"across is wrong from record 6 on", [](SurfaceMeshData& m, Validation&) { m.across[6][1] ^= 1; }},
        {"ring is wrong from record 2 on",
         [](SurfaceMeshData& m, Validation&) { std::swap(m.ring[2], m.ring[3]); }},
        {"fan is wrong from record 4 on", [](SurfaceMeshData& m, Validation&) { m.fan[4] = m.fan[3]; }},
        {"shell is wrong from record 9 on", [](SurfaceMeshData& m, Validation&) { m.shell[9] = 1; }},
        {"its bounds are not those of its vertices",
         [](SurfaceMeshData& m, Validation&) { m.bounds.max.x += 1; }},
        {"what it says of itself is not what counting gives",
         [](SurfaceMeshData&, Validation& v) { v.edges += 1; }},
        {"what it says of itself is not what counting gives",
         [](SurfaceMeshData&, Validation& v) { v.flipped = 1; }},
        {"what it says of itself is not what counting gives",
         [](SurfaceMeshData&, Validation& v) { v.nonmanifold_vertices = 1; }}};
    for (const auto& [sentence, spoil] : cases) {
        SurfaceMeshData mesh = sound;
        Validation said = validation;
        spoil(mesh, said);
        CHECK_THROWS_WITH(verify(mesh.view(), said, "m"),
                          "m: is unsound: " + std::string(sentence) + "; bake it again with orbweaver-assets");
    }
}
