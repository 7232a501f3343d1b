#include "grip_options.hpp"

#include <catch2/catch.hpp>

#include "fake_host.hpp"
#include "obj_mesh.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::test::FakeHost;

namespace {

struct Asked {
    mesh::SurfaceMeshData data = [] {
        mesh::RawMesh raw = mesh::cube(1, 1);
        raw.material_names = {"stone", "Glass.001"};
        raw.material[0] = 1;
        return surface::test::built(raw);
    }();
    FakeHost host;
    void set(const std::string& key, OptionValue value, int line = 3) {
        host.set(key, std::move(value), {"s.toml", line, 1});
    }
    GripOverrides grips() { return grips_of(data.view(), host); }
};

}  // namespace

TEST_CASE("a scene gives grips by material and by polygons, whatever their names hold", "[unit]") {
    Asked asked;
    asked.set("friction", 0.5);
    asked.set("material.Glass.001.friction", 0.1);
    asked.set("material.Glass.001.climbable", false);
    asked.set("patch.window.polygons", std::string("2-3, 5"));
    asked.set("patch.window.climbable", false);
    asked.set("patch.mat.polygons", std::string("4"));
    asked.set("patch.mat.friction", 2.0);
    const GripOverrides grips = asked.grips();
    CHECK(asked.host.faults.empty());
    const double friction[] = {0.1, 0.5, 0.5, 0.5, 2, 0.5};
    const bool climbable[] = {false, true, false, false, true, false};
    for (std::uint32_t face = 0; face < 12; ++face) {
        const std::uint32_t polygon = asked.data.polygon[face];
        CAPTURE(polygon);
        CHECK(grips.grip(asked.data.view(), face).friction == friction[polygon]);
        CHECK(grips.grip(asked.data.view(), face).climbable == climbable[polygon]);
    }
}

TEST_CASE("what a scene gets wrong of grips is told at its place, all at once", "[extreme]") {
    Asked asked;
    asked.set("material.ice.friction", 0.1, 3);
    asked.set("patch.a.friction", 0.1, 4);
    asked.set("patch.b.polygons", std::string("1;2"), 5);
    asked.set("patch.c.polygons", std::string("0-6"), 6);
    asked.set("patch.d.polygons", std::string("1-2"), 7);
    asked.set("patch.e.polygons", std::string("1-3"), 8);
    asked.set("patch.e.friction", 0.2, 9);
    asked.set("patch.f.polygons", std::string("0, 3-4"), 10);
    asked.set("patch.f.friction", 0.3, 11);
    asked.grips();
    std::vector<std::string> said;
    for (const Diagnostic& fault : asked.host.faults) said.push_back(to_string(fault));
    CHECK(
        said ==
        std::vector<std::string>{
            "s.toml:3:1: the mesh has no material 'ice'; expected one of 'stone', 'Glass.001'",
            "s.toml:4:1: patch 'a' names no polygons; expected a list of polygons such as \"0-11, 15\"",
            "s.toml:5:1: patch 'b' has the polygons \"1;2\"; expected a list of polygons such as \"0-11, 15\"",
            "s.toml:6:1: patch 'c' names polygon 6; expected 0 to 5, the mesh's",
            "s.toml:7:1: patch 'd' says nothing of its polygons; expected 'friction' or 'climbable'",
            "s.toml:10:1: polygon 3 is in patch 'e' and in patch 'f'; expected patches that do not overlap"});
}

TEST_CASE("a list that names the same polygons again and again is held once", "[extreme]") {
    Asked asked;
    std::string list = "0-5";
    for (int i = 0; i < 10'000; ++i) list += ",0-5, 3";
    asked.set("patch.all.polygons", list);
    asked.set("patch.all.friction", 0.3);
    const GripOverrides grips = asked.grips();
    CHECK(asked.host.faults.empty());
    CHECK(grips.patched.size() == 1);
    CHECK(grips.grip(asked.data.view(), 11).friction == 0.3);
}
