#include "study/query_reference.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "orbweaver/random.hpp"
#include "support/asked_surface.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using orbweaver::test::AskedSurface;

namespace {

Stance ray(const Vec3& from, const Vec3& direction) {
    Stance question;
    question.position = from;
    question.up = -direction / norm(direction);
    return question;
}

}  // namespace

TEST_CASE("a ray's first crossing of a cube is where the closed form has it", "[unit]") {
    const AskedSurface cube(mesh::cube(2, 3));
    const QueryReference reference(cube.surface);
    const RandomStream random(5, "rays");
    for (std::uint64_t i = 0; i < 300; ++i) {
        const double x = random.uniform(4 * i, -0.99, 0.99), z = random.uniform(4 * i + 1, -0.99, 0.99);
        const QueryTruth down = reference.crossing(ray({x, 3, z}, {0, -1, 0}));
        REQUIRE(down.certain);
        REQUIRE_FALSE(down.places.empty());
        for (const Vec3& place : down.places) CHECK(distance(place, {x, 1, z}) < 1e-15);
        CHECK(reference.crossing(ray({x, 3, z}, {0, 1, 0})).places.empty());
        CHECK(reference.crossing(ray({x + 2, 3, z}, {0, -1, 0})).places.empty());
    }
    Stance near = ray({0.1, 3, 0.2}, {0, -1, 0});
    near.reach = 1.9;
    CHECK(reference.crossing(near).places.empty());
}

TEST_CASE("no ray slips between faces, and past a rim both answers are right", "[extreme]") {
    const AskedSurface cube(mesh::cube(2, 4));
    const QueryReference reference(cube.surface);
    // Within the top face: at its edges and vertices there is no way through.
    for (const double x : {-0.5, 0.0, 0.5})
        for (const double z : {-0.5, 0.0, 0.3, 0.5}) {
            const QueryTruth truth = reference.crossing(ray({x + 0.125, 3, z - 0.25}, {-0.125, -2, 0.25}));
            CHECK(truth.certain);
            for (const Vec3& place : truth.places) CHECK(distance(place, {x, 1, z}) < 1e-14);
        }
    // Along the upper edge's outside, from above: it may be met, or the ray may pass by it and meet nothing.
    const QueryTruth rim = reference.crossing(ray({2, 2, 0.1}, {-1, -1, 0}));
    CHECK(rim.certain);  // it goes into the cube there
    const QueryTruth past = reference.crossing(ray({2, 0, 0.1}, {-1, 1, 0}));
    CHECK_FALSE(past.certain);
    // A corner of an open quarter of a plane: its two faces at the corner do not surround the ray.
    const AskedSurface sheet(mesh::height_field(2, 2));
    const Vec3 corner = sheet.data.bounds.min;
    for (const Vec3& v : sheet.data.vertices)
        if (v.x == corner.x && v.z == corner.z)
            CHECK_FALSE(QueryReference(sheet.surface).crossing(ray({v.x, 5, v.z}, {0, -1, 0})).certain);
}

TEST_CASE("the nearest point of a cube is where the closed form has it, within reach", "[unit]") {
    const AskedSurface cube(mesh::cube(2, 3));
    const QueryReference reference(cube.surface);
    const RandomStream random(6, "points");
    for (std::uint64_t i = 0; i < 300; ++i) {
        Stance question;
        question.position = {random.uniform(3 * i, -4, 4), random.uniform(3 * i + 1, 1.01, 4),
                             random.uniform(3 * i + 2, -4, 4)};
        const Vec3& p = question.position;
        const Vec3 expected{std::clamp(p.x, -1.0, 1.0), 1, std::clamp(p.z, -1.0, 1.0)};
        REQUIRE(reference.nearest(question).places.size() == 1);
        CHECK(distance(reference.nearest(question).places[0], expected) < 1e-14);
        question.reach = 0.99 * distance(p, expected);
        CHECK(reference.nearest(question).places.empty());
    }
}
