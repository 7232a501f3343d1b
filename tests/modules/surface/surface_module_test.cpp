#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "fake_host.hpp"
#include "mesh_file.hpp"
#include "obj_mesh.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "plan/manifest.hpp"
#include "scratch.hpp"
#include "shapes.hpp"
#include "tree_file.hpp"

using namespace orbweaver;
using orbweaver::surface::build_wide_tree;
using orbweaver::surface::WideTreeData;
using test::FakeHost;
using test::LoadedModule;

namespace {

enum class Tree { none, baked, broken };

void bake(const std::string& path, const mesh::RawMesh& raw, Tree kind) {
    mesh::Validation validation;
    const auto data = mesh::build_surface_mesh(raw, {}, "the test's mesh", validation);
    WideTreeData tree = build_wide_tree({data.vertices, data.triangles});
    if (kind == Tree::broken) tree.nodes[0].children[0] = 77'777;
    BakedWriter writer(mesh::kMeshType, mesh::kMeshVersion, {});
    mesh::add_mesh(writer, data.view(), validation);
    if (kind != Tree::none) surface::add_tree(writer, tree);
    writer.write(path);
}

FakeHost host_for(const std::string& path) {
    FakeHost host;
    host.set("mesh", path, {"scene.toml", 3, 1});
    host.set("position", Vec3{});
    return host;
}

Surface& surface_of(FakeHost& host) {
    REQUIRE(host.contracts[Surface::kContract].size() == 1);
    return *static_cast<Surface*>(host.contracts[Surface::kContract].front());
}

std::string measure(LoadedModule& module, const std::string& name) {
    for (const auto& [key, value] : module.report().measures)
        if (key == name) return std::get<std::string>(value);
    return "";
}

}  // namespace

TEST_CASE("whoever never leaves a flat floor has no tree made", "[unit]") {
    const test::Scratch folder;
    bake(folder.path("floor.baked"), mesh::t_junction(2, 8), Tree::none);
    LoadedModule module("surface");
    FakeHost host = host_for(folder.path("floor.baked"));
    REQUIRE(module.attach(host));
    const Surface& surface = surface_of(host);
    CHECK(surface.size() == 2);
    SurfaceStep at = surface.place({0, {0.4, 0.3, 0.3}}, {0, 1, 0}, {1, 0, -0.3});
    REQUIRE(at.answer == Answer::found);
    std::uint32_t last = at.end.at.face;
    for (int i = 0; i < 40; ++i) {
        at = surface.step(at.end, 0.01);
        REQUIRE(at.stop == StepStop::none);
        const Underfoot found = surface.underfoot(
            {at.end.position + Vec3{0, 0.02, 0}, at.end.up, at.end.forward, last, at.end.side, 0.1});
        REQUIRE(found.hit.answer == Answer::found);
        last = found.hit.at.face;
    }
    REQUIRE(module.run());
    CHECK(measure(module, "tree") == "none: nobody asked for it");
    // A ray asks for one.
    CHECK(surface.first_hit({{0.1, 1, 0.1}, {0, -1, 0}}).distance == 1);
    CHECK(measure(module, "tree") == "made when first asked for");
}

TEST_CASE("a flat floor answers everything without a mesh and without a tree", "[unit]") {
    LoadedModule module("surface");
    FakeHost host;
    host.set("floor", 4.0, {"scene.toml", 3, 1});
    host.set("position", Vec3{1, 0.5, -2});
    host.set("friction", 0.3, {});
    REQUIRE(module.attach(host));
    const Surface& surface = surface_of(host);
    CHECK(surface.size() == 4);
    CHECK(surface.grip(1).friction == 0.3);
    CHECK(surface.polygons()[0] == surface.polygons()[1]);
    for (const double x : {-0.9, 0.2, 2.7})
        for (const double z : {-3.8, -2.0, -0.1}) {
            CAPTURE(x, z);
            const SurfaceHit down = surface.first_hit({{x, 3, z}, {0, -2, 0}});
            REQUIRE(down.answer == Answer::found);
            CHECK(std::abs(down.distance - 1.25) < 1e-15);
            CHECK(surface.normal(down.at.face) == Vec3{0, 1, 0});
            CHECK(distance(surface.position(surface.closest_point({x, -0.5, z}, 1).at), {x, 0.5, z}) < 1e-15);
            const Underfoot under = surface.underfoot({{x, 0.6, z}, {0, 1, 0}, {1, 0, 0}});
            REQUIRE(under.hit.answer == Answer::found);
            CHECK(distance(surface.position(under.hit.at), {x, 0.5, z}) < 1e-15);
            CHECK(surface.underfoot({{x, 0.6, z}, {0, 1, 0}, {1, 0, 0}, 0, 1, 0.05}).hit.answer ==
                  Answer::nothing);
        }
    CHECK(surface.first_hit({{3.1, 3, 0}, {0, -1, 0}}).answer == Answer::nothing);
    CHECK(surface.first_hit({{0, 3, 0}, {0, 0, 0}}).answer == Answer::refused);
    CHECK(surface.closest_point({3.5, 0.5, -2}, 0.4).answer == Answer::nothing);
    CHECK(surface.closest_point({3.5, 0.5, -2}, 0.6).distance == Approx(0.5));
    // Beyond the rim the scan or the nearest point finds the way back.
    const Underfoot beyond = surface.underfoot({{3.01, 0.6, -2}, {0, 1, 0}, {1, 0, 0}});
    REQUIRE(beyond.hit.answer == Answer::found);
    CHECK(distance(surface.position(beyond.hit.at), {3, 0.5, -2}) < 0.1);
    SurfaceStep at = surface.place({0, {0.4, 0.3, 0.3}}, {0, 1, 0}, {1, 0, 0.1});
    at = surface.stride(at.end, 100, {}).step;
    CHECK(at.stop == StepStop::border);
    CHECK(at.end.position.x == Approx(3));
    REQUIRE(module.run());
    CHECK(measure(module, "tree") == "none: so few triangles need none");
}

TEST_CASE("each shape of our own is one of the manifest's choices, and is made as large as asked", "[unit]") {
    const Manifest manifest = *[] {
        Diagnostics faults;
        return read_manifest(std::string(ORBWEAVER_MODULE_DIR) + "/surface.toml", faults);
    }();
    const auto option = std::find_if(manifest.options.begin(), manifest.options.end(),
                                     [](const OptionSpec& spec) { return spec.key == "shape"; });
    REQUIRE(option != manifest.options.end());
    REQUIRE(option->choices.size() == mesh::shapes().size());
    for (std::size_t i = 0; i < option->choices.size(); ++i) {
        const std::string& name = option->choices[i];
        CAPTURE(name);
        CHECK(name == mesh::shapes()[i].name);
        LoadedModule module("surface");
        FakeHost host;
        host.set("shape", name);
        host.set("subdivision", std::int64_t{3});
        host.set("size", 4.0);
        host.set("position", Vec3{});
        REQUIRE(module.attach(host));
        CHECK(surface_of(host).size() == Approx(4));
    }
}

// As large as a bacterium and as a country, and a million radii from the origin: the answers of the shape at 1
// m, to the rounding of places so far away, 1e6 times half a unit in the last place, a few times over.
TEST_CASE("a tiny, a huge and a far-away shape answer as the one at the origin does", "[extreme]") {
    for (const char* shape : {"sphere", "cube", "torus", "cliff"})
        for (const auto& [size, radii] : {std::pair{1e-8, 0.0},
                                          {1e-8, 1e6},
                                          {1e-4, 1e6},
                                          {1.0, 1e6},
                                          {10.0, 2e6},
                                          {1e6, 0.0},
                                          {1e7, 0.0}}) {
            CAPTURE(shape, size, radii);
            const Vec3 place = radii * size / 2 * Vec3{1, -1, 1};
            LoadedModule near_module("surface"), module("surface");
            FakeHost near_host, host;
            for (FakeHost* each : {&near_host, &host}) {
                each->set("shape", std::string(shape));
                each->set("subdivision", std::int64_t{5});
            }
            near_host.set("position", Vec3{});
            host.set("size", size);
            host.set("position", place);
            REQUIRE(near_module.attach(near_host));
            REQUIRE(module.attach(host));
            const Surface& one = surface_of(near_host);
            const Surface& other = surface_of(host);
            const double tolerance = 8 * (1 + radii) * 2.2e-16;
            const auto same_place = [&](const Vec3& expected, const Vec3& found) {
                CHECK(distance(size * expected + place, found) <= tolerance * size);
            };
            const Vec3 above{0.11, 0.9, 0.07};
            const SurfaceHit hit = one.first_hit({above, {0.05, -1, 0.3}});
            const SurfaceHit found = other.first_hit({size * above + place, {0.05, -1, 0.3}});
            REQUIRE(found.answer == hit.answer);
            if (hit.answer == Answer::found) {
                CHECK(std::abs(found.distance - size * hit.distance) <= tolerance * size);
                same_place(one.position(hit.at), other.position(found.at));
            }
            const SurfaceHit nearest = one.closest_point(above, 2);
            const SurfaceHit found_nearest = other.closest_point(size * above + place, 2 * size);
            REQUIRE(nearest.answer == Answer::found);
            REQUIRE(found_nearest.answer == Answer::found);
            same_place(one.position(nearest.at), other.position(found_nearest.at));
            const SurfaceStep from = one.place(nearest.at, {0, 1, 0}, {1, 0.2, 0.4});
            const SurfaceStep found_from = other.place(nearest.at, {0, 1, 0}, {1, 0.2, 0.4});
            const SurfaceStep end = one.step(from.end, 0.3);
            const SurfaceStep found_end = other.step(found_from.end, 0.3 * size);
            REQUIRE(end.answer == Answer::found);
            REQUIRE(found_end.answer == Answer::found);
            CHECK(found_end.stop == end.stop);
            same_place(end.end.position, found_end.end.position);
        }
}

TEST_CASE("a surface is scaled and moved as the scene says, its baked tree with it", "[unit]") {
    const test::Scratch folder;
    bake(folder.path("ball.baked"), mesh::sphere(1, 12), Tree::baked);
    LoadedModule module("surface");
    FakeHost host = host_for(folder.path("ball.baked"));
    host.set("size", 6.0, {});
    host.set("position", Vec3{10, 20, 30});
    host.set("friction", 0.25, {});
    host.set("climbable", false, {});
    REQUIRE(module.attach(host));
    const Surface& surface = surface_of(host);
    CHECK(surface.size() == Approx(6));
    CHECK(surface.grip(5).friction == 0.25);
    CHECK_FALSE(surface.grip(5).climbable);
    CHECK(measure(module, "tree") == "baked");
    const SurfaceHit down = surface.first_hit({{10, 40, 30}, {0, -1, 0}});
    REQUIRE(down.answer == Answer::found);
    CHECK(down.distance == Approx(17));
    CHECK(distance(surface.position(down.at), {10, 23, 30}) < 1e-13);
    CHECK(dot(surface.normal(down.at.face), {0, 1, 0}) > 0.9);
    CHECK(distance(surface.position(surface.closest_point({10, 10, 30}, 100).at), {10, 17, 30}) < 1e-14);
    CHECK(surface.first_hit({{10, 40, 33.1}, {0, -1, 0}}).answer == Answer::nothing);
}

TEST_CASE("a material's own grip holds where the scene says nothing", "[unit]") {
    const test::Scratch folder;
    bake(folder.path("cube.baked"), mesh::cube(1, 1), Tree::baked);
    LoadedModule module("surface");
    FakeHost host = host_for(folder.path("cube.baked"));
    REQUIRE(module.attach(host));
    CHECK(surface_of(host).grip(0).friction == mesh::SurfaceProperty{}.friction);
    CHECK(surface_of(host).grip(0).climbable);
    CHECK(surface_of(host).polygons()[0] == surface_of(host).polygons()[1]);  // the halves of a quad
}

TEST_CASE("a surface that cannot be is told at its place in the scene", "[unit]") {
    const test::Scratch folder;
    bake(folder.path("broken.baked"), mesh::cube(1, 3), Tree::broken);
    struct Case {
        std::string path;
        std::string what;
    };
    for (const auto& [path, what] :
         {Case{folder.path("broken.baked"), "is unsound: node 0 of the tree has node 77777 below it"},
          Case{folder.write("cube.obj", "v 0 0 0\n"), "is not baked yet; run orbweaver-assets bake"}}) {
        LoadedModule module("surface");
        FakeHost host = host_for(path);
        CHECK(module.attach(host));
        REQUIRE(host.faults.size() == 1);
        CHECK(host.faults[0].where.line == 3);
        CHECK_THAT(host.faults[0].what, Catch::Contains(what));
        CHECK(host.contracts.empty());
    }
    const auto what_is_wrong = [](const std::vector<std::string>& keys) {
        LoadedModule module("surface");
        FakeHost host;
        for (const std::string& key : keys)
            host.set(key, key == "mesh" ? OptionValue(std::string("cube.baked")) : OptionValue(2.0));
        CHECK(module.attach(host));
        REQUIRE(host.faults.size() == 1);
        CHECK(host.contracts.empty());
        return host.faults[0].what;
    };
    CHECK(what_is_wrong({}) == "the surface has no mesh, no shape and no flat floor");
    CHECK(what_is_wrong({"mesh", "floor"}) ==
          "the surface has more than one of a mesh, a shape and a flat floor");
    CHECK(what_is_wrong({"floor", "size"}) == "'size' scales a mesh, and this surface is a flat floor");
}
