#include "underfoot.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "geodesic.hpp"
#include "obj_mesh.hpp"
#include "orbweaver/random.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::built;
using orbweaver::surface::test::read_obj;

namespace {

/// The face under a place just above it: by the tree, which knows no neighbours.
std::uint32_t face_at(const mesh::SurfaceMesh& mesh, const Vec3& position, const Vec3& up) {
    const WideTreeData tree = build_wide_tree(triangles_of(mesh));
    const SurfaceHit hit = first_hit(tree.view(), triangles_of(mesh), {position + up, -up});
    REQUIRE(hit.answer == Answer::found);
    return hit.at.face;
}

}  // namespace

TEST_CASE("over a flat floor the polygon is found without a tree, the cheapest way first", "[unit]") {
    const auto floor = built(mesh::t_junction(2, 16));
    const auto mesh = floor.view();
    const ReadyParts parts(mesh);
    struct Case {
        Vec3 from, to;
        FoundBy by;
    };
    const std::vector<Case> cases = {{{0.313, 0, 0.317}, {0.314, 0, 0.318}, FoundBy::current},
                                     {{0.313, 0, 0.317}, {0.367, 0, 0.317}, FoundBy::walk},
                                     {{0.313, 0, 0.317}, {0.573, 0, 0.471}, FoundBy::walk}};
    for (const auto& [from, to, by] : cases) {
        const std::uint32_t last = face_at(mesh, from, {0, 1, 0});
        const Underfoot found =
            underfoot(mesh, parts, {to + Vec3{0, 0.05, 0}, {0, 1, 0}, {1, 0, 0}, last, 1, 1});
        REQUIRE(found.hit.answer == Answer::found);
        CHECK(found.by == by);
        CHECK(found.hit.at.face == face_at(mesh, to, {0, 1, 0}));
        CHECK(distance(position_of(triangles_of(mesh), found.hit.at), to) < 1e-15);
        CHECK(found.hit.distance == Approx(0.05).epsilon(1e-14));
    }
    CHECK(parts.tree_bytes() == 0);
}

TEST_CASE("over a crack between squares the rings find what no edge joins", "[unit]") {
    const auto floor = built(mesh::t_junction(2, 4));  // its halves share only every other vertex of x = 0
    const auto mesh = floor.view();
    const ReadyParts parts(mesh);
    const std::uint32_t last = face_at(mesh, {-0.03, 0, 0.11}, {0, 1, 0});
    const Underfoot found = underfoot(mesh, parts, {{0.02, 0.05, 0.11}, {0, 1, 0}, {1, 0, 0}, last, 1, 1});
    CHECK(found.hit.answer == Answer::found);
    CHECK(found.by == FoundBy::rings);
    CHECK(found.hit.at.face == face_at(mesh, {0.02, 0, 0.11}, {0, 1, 0}));
    CHECK(parts.tree_bytes() == 0);
}

TEST_CASE("beyond a cube's edge the scan finds the side, whichever way the body came", "[unit]") {
    const auto cube = built(mesh::cube(2, 4));
    const auto mesh = cube.view();
    const ReadyParts parts(mesh);
    const std::uint32_t last = face_at(mesh, {0.95, 1, 0.3}, {0, 1, 0});
    for (const Vec3& forward : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0.6, 0, 0.8}}) {
        const Underfoot found = underfoot(mesh, parts, {{1.02, 1.05, 0.3}, {0, 1, 0}, forward, last, 1, 1});
        REQUIRE(found.hit.answer == Answer::found);
        CHECK(found.by == FoundBy::scan);
        CHECK(distance(face_normal(triangles_of(mesh), found.hit.at.face), {1, 0, 0}) < 1e-15);
    }
    CHECK(parts.tree_bytes() == 0);
}

TEST_CASE("who does not know where it was, or was carried off, asks the tree", "[unit]") {
    const auto ball = built(mesh::sphere(2, 16));
    const auto mesh = ball.view();
    const ReadyParts parts(mesh);
    const Vec3 up = unit({0.2, 0.5, -0.7});
    for (const std::uint32_t last : {kNoFace, face_at(mesh, {0, -1, 0}, {0, -1, 0})}) {
        const Underfoot found = underfoot(mesh, parts, {1.1 * up, up, {1, 0, 0}, last, 1, 1});
        CHECK(found.by == FoundBy::tree);
        CHECK(found.hit.at.face == face_at(mesh, up, up));
    }
    CHECK(parts.tree_bytes() > 0);
    // Out of reach there is nothing.
    CHECK(underfoot(mesh, parts, {3 * up, up, {1, 0, 0}, kNoFace, 1, 1}).hit.answer == Answer::nothing);
}

TEST_CASE("a stance that means nothing is refused", "[unit]") {
    const auto cube = built(mesh::cube(2, 1));
    const ReadyParts parts(cube.view());
    const double nan = std::nan("");
    const Vec3 y{0, 1, 0}, x{1, 0, 0};
    for (const Stance& stance :
         {Stance{{nan, 0, 0}, y, x, 0}, Stance{y, {0, nan, 0}, x, 0}, Stance{y, y, {nan, 0, 0}, 0},
          Stance{y, {}, x, 0}, Stance{y, y, x, 0, 1, nan}, Stance{y, y, x, 0, 1, -1}, Stance{y, y, x, 0, 0}})
        CHECK(underfoot(cube.view(), parts, stance).hit.answer == Answer::refused);
    CHECK(parts.tree_bytes() == 0);
}

TEST_CASE("a walker asked every few steps is always found, and where it is", "[extreme]") {
    for (const char* name : {"spot", "fandisk", "stanford-bunny"}) {
        CAPTURE(name);
        const auto data = built(read_obj(std::string(ORBWEAVER_MESHES "/") + name + ".obj"));
        const auto mesh = data.view();
        const auto set = triangles_of(mesh);
        const ReadyParts parts(mesh);
        const Vec3 extent = mesh.bounds.max - mesh.bounds.min;
        const double size = std::max({extent.x, extent.y, extent.z});
        const RandomStream random(5, "underfoot");
        Footing at =
            place(mesh, {0, {0.4, 0.3, 0.3}}, face_normal(set, 0), mesh.corner(0, 1) - mesh.corner(0, 0)).end;
        std::uint32_t last = 0;
        int lost = 0, far_off = 0, differ = 0;
        std::map<FoundBy, int> by;
        constexpr int kAsked = 50'000;
        for (int i = 0; i < kAsked; ++i) {
            const Vec3 left = cross(at.up, at.forward);
            const double a = random.uniform(2 * static_cast<std::uint64_t>(i), -1, 1);
            const double length = 0.01 * size * random.uniform(2 * static_cast<std::uint64_t>(i) + 1);
            const SurfaceStep end = step(mesh, place(mesh, at.at, at.up, at.forward + a * left).end, length);
            if (end.stop == StepStop::border) {
                at.forward = -at.forward;
                continue;
            }
            at = end.end;
            const double height = 1e-3 * size;
            const Underfoot found = underfoot(
                mesh, parts, {at.position + height * at.up, at.up, at.forward, last, 1, 1.5 * height});
            ++by[found.by];
            if (found.hit.answer != Answer::found) {
                ++lost;
                continue;
            }
            // What is found by walking is the crossing that the tree's triangle test finds there, to the last
            // bit.
            if (found.by <= FoundBy::rings) {
                const SurfaceRay ray{at.position + height * at.up, -at.up, 1.5 * height};
                const SurfaceHit hit = first_hit(*parts.tree(), set, ray);
                if (hit.at.face == found.hit.at.face)
                    differ += hit.distance != found.hit.distance || hit.at.weights != found.hit.at.weights;
            }
            // It may be another face that lies nearer below, never one that lies farther.
            if (found.hit.distance > height * (1 + 1e-9)) ++far_off;
            last = found.hit.at.face;
        }
        CHECK(lost == 0);
        CHECK(far_off == 0);
        CHECK(differ == 0);
        CHECK(by[FoundBy::current] + by[FoundBy::walk] > kAsked / 2);
    }
}
