#include "shown_lines.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "fake_host.hpp"
#include "mesh_surface.hpp"
#include "obj_mesh.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::test::FakeHost;

namespace {

struct Drawn {
    mesh::SurfaceMeshData data = surface::test::built(mesh::cube(2, 4));
    MeshSurface surface{data.view(), std::nullopt, {}};
    FakeHost host;
    ShownLines lines;

    void set(const std::string& name, const Vec3& from, const Vec3& along, double length) {
        host.set("line." + name + ".from", from, {"s.toml", 4, 1});
        host.set("line." + name + ".along", along, {"s.toml", 5, 1});
        host.set("line." + name + ".length", length, {"s.toml", 6, 1});
    }
};

}  // namespace

TEST_CASE("a line goes straight round a cube and comes back to where it began", "[unit]") {
    Drawn drawn;
    drawn.set("belt", {0, 1.5, 0.3}, {1, 0, 0}, 8);
    drawn.lines.draw(drawn.surface, drawn.host);
    CHECK(drawn.host.faults.empty());
    const auto points = drawn.lines.points();
    REQUIRE(points.size() == 401);
    REQUIRE(drawn.lines.segments().size() == 400);
    CHECK(distance(points.front(), {0, 1.004, 0.3}) < 1e-12);
    CHECK(distance(points.back(), points.front()) < 1e-12);
    for (const Vec3& p : points) {
        CHECK(p.z == Approx(0.3).epsilon(1e-12));
        CHECK(std::max(std::abs(p.x), std::abs(p.y)) == Approx(1.004).epsilon(1e-12));
    }
}

TEST_CASE("lines are apart from each other, and lie on the side that they begin on", "[unit]") {
    Drawn drawn;
    drawn.set("above", {0, 1.5, 0}, {1, 0, 0}, 0.1);
    drawn.set("within", {0, 0.5, 0}, {1, 0, 0}, 0.1);
    drawn.lines.draw(drawn.surface, drawn.host);
    REQUIRE(drawn.lines.points().size() == 12);
    CHECK(drawn.lines.points()[0].y == Approx(1.004));
    CHECK(drawn.lines.points()[6].y == Approx(0.996));
    CHECK(drawn.lines.segments()[5].a == 6);
}

TEST_CASE("what a scene gets wrong of a line is told at its place", "[extreme]") {
    Drawn drawn;
    drawn.set("up", {0, 1.5, 0}, {0, 1, 0}, 1);
    drawn.host.set("line.bare.from", Vec3{}, {"s.toml", 9, 1});
    drawn.lines.draw(drawn.surface, drawn.host);
    std::vector<std::string> said;
    for (const Diagnostic& fault : drawn.host.faults) said.push_back(to_string(fault));
    REQUIRE(said.size() == 3);
    CHECK_THAT(said[0], Catch::EndsWith("line 'bare' has no 'along'; expected 'from', 'along' and 'length'"));
    CHECK_THAT(said[1], Catch::EndsWith("line 'bare' has no 'length'; expected 'from', 'along' and 'length'"));
    CHECK(said[2] == "s.toml:5:1: line 'up' points out of the surface; expected a direction along it");
}
