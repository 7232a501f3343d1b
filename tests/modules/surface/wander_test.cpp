// Millions of steps at random over closed surfaces, and over open ones, where borders turn them back.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "geodesic.hpp"
#include "obj_mesh.hpp"
#include "orbweaver/random.hpp"
#include "ready_parts.hpp"
#include "sanitized.hpp"
#include "shapes.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;
using orbweaver::surface::test::built;
using orbweaver::surface::test::read_obj;

namespace {

/// How often a closed surface winds about a point: by the solid angles of its faces (Van Oosterom and Strackee
/// 1983). Knows nothing of trees, neighbours or steps.
int winding_number(const mesh::SurfaceMesh& mesh, const Vec3& at) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 a = mesh.corner(t, 0) - at, b = mesh.corner(t, 1) - at, c = mesh.corner(t, 2) - at;
        const double la = norm(a), lb = norm(b), lc = norm(c);
        sum += std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
    }
    return static_cast<int>(std::lround(sum / (2 * 3.14159265358979323846)));
}

struct Wander {
    int lost = 0;
    int through = 0;
    double worst_off = 0;       // of the surface's size, from the plane of the face that it is said to be on
    double worst_distance = 0;  // of the size, from the nearest point of the surface; sampled
};

/// `steps` steps of up to a twentieth of the size, each in a direction of its own.
Wander wander(const mesh::SurfaceMesh& mesh, int side, int steps) {
    const auto set = triangles_of(mesh);
    const WideTreeData tree = build_wide_tree(set);
    const Vec3 extent = mesh.bounds.max - mesh.bounds.min;
    const double size = std::max({extent.x, extent.y, extent.z});
    const RandomStream random(3, "wander");
    Footing at{{0, {0.4, 0.3, 0.3}}, side, {}, {}, {}};
    at = place(mesh, at.at, side * face_normal(set, 0), mesh.corner(0, 1) - mesh.corner(0, 0)).end;
    const auto winding = [&] { return winding_number(mesh, at.position + 1e-7 * size * at.up); };
    const int where = winding();
    const int samples = 100'000'000 / static_cast<int>(mesh.triangles.size() + 1) / 10 + 50;
    const int every = std::max(1, steps / samples);
    Wander result;
    std::uint64_t n = 0;
    for (int i = 0; i < steps; ++i) {
        const double a = random.uniform(n++, -1, 1);  // steers by up to 45 degrees
        const Vec3 left = cross(at.up, at.forward);
        const SurfaceStep turned = place(mesh, at.at, at.up, at.forward + a * left);
        const double length = 0.05 * size * random.uniform(n++);
        const SurfaceStep end = step(mesh, turned.end, length);
        if (end.answer != Answer::found || end.stop != StepStop::none || end.walked != length) {
            ++result.lost;
            continue;
        }
        at = end.end;
        if (at.side != side) ++result.through;
        result.worst_off =
            std::max(result.worst_off, std::abs(dot(at.position - mesh.corner(at.at.face, 0), at.up)) / size);
        if (i % every != 0) continue;
        if (winding() != where) ++result.through;
        const SurfaceHit nearest = closest_point(tree.view(), set, at.position, size);
        result.worst_distance = std::max(result.worst_distance, nearest.distance / size);
    }
    return result;
}

void check_wander(const mesh::RawMesh& raw, int side) {
    const auto data = built(raw);
    mesh::Validation found;
    mesh::SurfaceMeshData joined = data;
    mesh::join(joined, found);
    REQUIRE(found.border_edges == 0);
    constexpr int kSteps = repetitions(250'000);
    const Wander result = wander(data.view(), side, kSteps);
    CHECK(result.lost == 0);
    CHECK(result.through == 0);
    CHECK(result.worst_off <= 1e-9);
    CHECK(result.worst_distance <= 1e-9);
}

}  // namespace

TEST_CASE("a quarter of a million steps each: outside a cube, inside it, and in a room", "[extreme]") {
    check_wander(mesh::cube(2, 4), 1);
    check_wander(mesh::cube(2, 4), -1);
    check_wander(mesh::room(3, 5), 1);
}

TEST_CASE("a quarter of a million steps each over a torus, a branch and a sphere", "[extreme]") {
    check_wander(mesh::torus(1, 8), 1);
    check_wander(mesh::branch(0.3, 4), 1);
    check_wander(mesh::sphere(1e-3, 12), 1);
}

TEST_CASE("a quarter of a million steps each over the closed ones among real meshes", "[extreme]") {
    for (const char* name : {"spot", "fandisk"}) {  // bunny, teapot and suzanne have borders
        CAPTURE(name);
        check_wander(read_obj(std::string(ORBWEAVER_MESHES "/") + name + ".obj"), 1);
    }
}

namespace {

/// Whether a place is on an edge, or at a vertex of one, beyond which there is nothing.
bool is_at_border(const mesh::SurfaceMesh& mesh, const SurfacePoint& at) {
    const auto is_border = [&](std::uint32_t face, std::uint32_t edge) {
        return mesh.across[face][edge] == mesh::kBorder;
    };
    for (std::uint32_t edge = 0; edge < 3; ++edge)
        if (at.weights[(edge + 2) % 3] == 0 && is_border(at.face, edge)) return true;
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
        if (at.weights[corner] != 1) continue;
        const std::uint32_t vertex = mesh.triangles[at.face][corner];
        for (const std::uint32_t face : mesh::ring_at(mesh, vertex))
            for (std::uint32_t edge = 0; edge < 3; ++edge)
                if (is_border(face, edge) && (mesh.triangles[face][edge] == vertex ||
                                              mesh.triangles[face][mesh::next_corner(edge)] == vertex))
                    return true;
    }
    return false;
}

struct OpenWander {
    int lost = 0;
    int borders = 0;            // steps that a border ended, and that turned back there
    int ended_elsewhere = 0;    // ended as if by a border, where there is none
    int turned_over = 0;        // on the other side of the surface
    double worst_off = 0;       // of the size, from the plane of the face
    double worst_distance = 0;  // of the size, from the nearest point of the surface; sampled
    double worst_walked = 0;    // of the size, between what was walked and the whole step; where no border was
};

/// A walk that begins on `face` and turns back wherever the surface ends.
void wander_open(const mesh::SurfaceMesh& mesh, const ReadyParts& parts, std::uint32_t face, int steps,
                 OpenWander& result) {
    const auto set = triangles_of(mesh);
    const Vec3 extent = mesh.bounds.max - mesh.bounds.min;
    const double size = std::max({extent.x, extent.y, extent.z});
    const RandomStream random(face, "wander");
    Footing at = place(mesh, {face, {0.4, 0.3, 0.3}}, face_normal(set, face),
                       mesh.corner(face, 1) - mesh.corner(face, 0))
                     .end;
    for (int i = 0; i < steps; ++i) {
        const double aside = random.uniform(2 * static_cast<std::uint64_t>(i), -1, 1);
        const double length = 0.05 * size * random.uniform(2 * static_cast<std::uint64_t>(i) + 1);
        const SurfaceStep turned = place(mesh, at.at, at.up, at.forward + aside * cross(at.up, at.forward));
        const SurfaceStep end = step(mesh, turned.end, length);
        if (turned.answer != Answer::found || end.answer != Answer::found || end.stop == StepStop::limit ||
            !is_finite(end.end.position)) {
            ++result.lost;
            continue;
        }
        at = end.end;
        result.turned_over += at.side != 1;
        result.worst_off =
            std::max(result.worst_off, std::abs(dot(at.position - mesh.corner(at.at.face, 0), at.up)) / size);
        if (end.stop == StepStop::border) {
            ++result.borders;
            result.ended_elsewhere += !is_at_border(mesh, at.at) || end.walked > length;
            at.forward = -at.forward;
        } else {
            result.worst_walked = std::max(result.worst_walked, std::abs(end.walked - length) / size);
        }
        if (i % 16 == 0)
            result.worst_distance = std::max(
                result.worst_distance, closest_point(*parts.tree(), set, at.position, size).distance / size);
    }
}

}  // namespace

TEST_CASE("a quarter of a million steps each over the open ones, whose borders end a step and say so",
          "[extreme]") {
    for (const char* name : {"stanford-bunny", "teapot", "suzanne"}) {
        CAPTURE(name);
        const auto data = built(read_obj(std::string(ORBWEAVER_MESHES "/") + name + ".obj"));
        const mesh::SurfaceMesh mesh = data.view();
        const ReadyParts parts(mesh);
        constexpr int kSteps = repetitions(250'000), kWalks = 50;
        OpenWander result;
        for (std::uint32_t walk = 0; walk < kWalks; ++walk)  // so that every shell has some
            wander_open(mesh, parts, static_cast<std::uint32_t>(walk * mesh.triangles.size() / kWalks),
                        kSteps / kWalks, result);
        CHECK(result.lost == 0);
        CHECK(result.borders > kSteps / 2500);
        CHECK(result.ended_elsewhere == 0);
        CHECK(result.turned_over == 0);
        CHECK(result.worst_off <= 1e-9);
        CHECK(result.worst_distance <= 1e-9);
        CHECK(result.worst_walked == 0);
    }
}
