#include <catch2/catch.hpp>
#include <cmath>

#include "fake_host.hpp"
#include "mesh_surface.hpp"
#include "obj_mesh.hpp"
#include "orbweaver/contracts/clearance.hpp"
#include "orbweaver/contracts/surface_ways.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using orbweaver::surface::MeshSurface;
using test::FakeHost;
using test::LoadedModule;

namespace {

std::string tree_of(LoadedModule& module) {
    for (const auto& [key, value] : module.report().measures)
        if (key == "tree") return std::get<std::string>(value);
    return "";
}

}  // namespace

TEST_CASE("FCL's tree is made when a body first asks how far the surface is", "[unit]") {
    const auto data = surface::test::built(mesh::cube(2, 3));
    MeshSurface cube(data.view(), std::nullopt, {});
    LoadedModule module("clearance");
    FakeHost host;
    host.offer<Surface>(cube);
    REQUIRE(module.attach(host));
    const auto& clearances = *static_cast<Clearances*>(host.contracts[Clearances::kContract].front());
    ProbeBody body;
    body.center = {0.1, 2, 0.1};
    body.size.x = 0.25;
    ProbeBody other = body;
    other.center.y = 4;
    CHECK(clearances.clearance(body, other).distance == Approx(1.5));
    REQUIRE(module.run());
    CHECK(tree_of(module) == "none: nobody asked for it");
    CHECK(clearances.clearance(body, INFINITY).distance == Approx(0.75));
    CHECK(tree_of(module) == "made when first asked for");
    CHECK(clearances.clearance(body, 0.5).answer == Answer::nothing);
    body.center.x = std::nan("");
    CHECK(clearances.clearance(body, INFINITY).answer == Answer::refused);
    REQUIRE(module.run());
}

TEST_CASE("rays through FCL's tree find what the surface's own ways find", "[unit]") {
    const auto data = surface::test::built(mesh::sphere(2, 6));
    MeshSurface ball(data.view(), std::nullopt, {});
    LoadedModule module("clearance");
    FakeHost host;
    host.offer<Surface>(ball);
    REQUIRE(module.attach(host));
    const auto& ways = *static_cast<SurfaceWays*>(host.contracts[SurfaceWays::kContract].front());
    REQUIRE(ways.ways().size() == 1);
    CHECK(ways.ways()[0].name == std::string("fcl_tree"));
    std::vector<Stance> questions;
    for (int i = -12; i <= 12; ++i) questions.push_back({{0.1 * i, 3, 0.05}, {0, 1, 0}, {1, 0, 0}});
    std::vector<SurfaceHit> hits(questions.size());
    ways.answer(0, questions, hits);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        const SurfaceHit own = ball.first_hit({questions[i].position, {0, -1, 0}});
        CHECK(hits[i].answer == own.answer);
        CHECK(hits[i].at.weights == own.at.weights);
    }
}
