#include "raw_mesh.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

#include "orbweaver/fault.hpp"
#include "sample_meshes.hpp"

using namespace orbweaver;
using namespace orbweaver::mesh;

TEST_CASE("a mesh that means nothing is refused in words", "[unit]") {
    struct Case {
        std::function<void(RawMesh&)> spoil;
        const char* sentence;
    };
    const std::vector<Case> cases = {
        {[](RawMesh& m) { m.points[2].y = std::numeric_limits<double>::quiet_NaN(); },
         "m.obj: point 2 is (1.000000, nan, 0.000000); expected finite coordinates within 1e50 m, "
         "so scale it down or export it again"},
        {[](RawMesh& m) { m.points[0].z = -std::numeric_limits<double>::infinity(); },
         "m.obj: point 0 is (0.000000, 0.000000, -inf); expected finite coordinates within 1e50 m, "
         "so scale it down or export it again"},
        {[](RawMesh& m) { m.corners[3] = 4; }, "m.obj: corner 3 is point 4 of 4; export the mesh again"},
        {[](RawMesh& m) {
             m.first = {0, 2, 4}, m.material = {0, 0};
         },
         "m.obj: polygon 0 has fewer than three corners; export the mesh again"},
        {[](RawMesh& m) {
             m.first = {0, 6, 4}, m.material = {0, 0};
         },
         "m.obj: polygon 1 has fewer than three corners; export the mesh again"},
        {[](RawMesh& m) { m.material[0] = 1; }, "m.obj: polygon 0 has material 1 of 1; export the mesh again"},
        {[](RawMesh& m) { m.material.clear(); },
         "m.obj: polygons, corners and materials disagree in number; export the mesh again"},
        {[](RawMesh& m) { m.first.clear(); },
         "m.obj: polygons, corners and materials disagree in number; export the mesh again"},
        {[](RawMesh& m) { m = RawMesh{}; },
         "m.obj: the mesh has no polygon; expected at least one (points and lines are no surface)"}};
    for (const Case& each : cases) {
        RawMesh raw = test::raw_mesh(test::kSquare, {{0, 1, 2, 3}});
        CHECK_NOTHROW(check(raw, "m.obj"));
        each.spoil(raw);
        CHECK_THROWS_WITH(check(raw, "m.obj"), each.sentence);
    }
}
