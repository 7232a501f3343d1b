#include "study/query_questions.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/asked_surface.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using orbweaver::test::AskedSurface;

namespace {

const QuestionSet& named(const std::vector<QuestionSet>& sets, const std::string& name) {
    for (const QuestionSet& set : sets)
        if (set.name == name) return set;
    FAIL("there are no questions named " + name);
    return sets[0];
}

}  // namespace

TEST_CASE("questions are the same for the same seed, and others for another", "[unit]") {
    const AskedSurface cube(mesh::cube(2, 3));
    const auto first = make_questions(cube.surface, 1, 50), again = make_questions(cube.surface, 1, 50);
    const auto other = make_questions(cube.surface, 2, 50);
    REQUIRE(first.size() == 5);
    for (std::size_t i = 0; i < first.size(); ++i) {
        REQUIRE(first[i].questions.size() == 50);
        CHECK(first[i].truths.size() == 50);
        for (std::size_t k = 0; k < 50; ++k)
            CHECK(first[i].questions[k].position == again[i].questions[k].position);
        CHECK(first[i].questions[0].position != other[i].questions[0].position);
    }
}

TEST_CASE("each kind of question is what its name says", "[unit]") {
    const AskedSurface cube(mesh::cube(2, 3));
    const auto sets = make_questions(cube.surface, 1, 200);
    for (const char* name : {"vertices", "edges"}) {
        const QuestionSet& set = named(sets, name);
        for (const Stance& question : set.questions) {
            double nearest = HUGE_VAL;  // of the vertices, or edges, from the ray's line
            for (std::size_t f = 0; f < cube.data.triangles.size(); ++f) {
                const Vec3 from = cube.data.view().corner(f, 0) - question.position;
                const Vec3 along = cube.data.view().corner(f, 1) - cube.data.view().corner(f, 0);
                const Vec3 across = cross(along, question.up);
                nearest =
                    std::min(nearest, set.name == "vertices" ? norm(cross(from, question.up))
                                                             : std::abs(dot(from, across)) / norm(across));
            }
            CHECK(nearest < 1e-14);
        }
    }
    const QuestionSet& random = named(sets, "random");
    CHECK(std::any_of(random.truths.begin(), random.truths.end(), [](const auto& t) { return t.certain; }));
    const QuestionSet& walk = named(sets, "underfoot");
    for (std::size_t i = 0; i < walk.questions.size(); ++i) {
        const Stance& q = walk.questions[i];
        CHECK(walk.truths[i].certain);
        CHECK(q.last < cube.data.triangles.size());
        // 0.01 of the size above a side of the cube, whose middle is the origin.
        CHECK(dot(q.position, q.up) == Approx(1.02).epsilon(1e-12));
    }
    const QuestionSet& beyond = named(sets, "over_edges");
    for (std::size_t i = 0; i < beyond.questions.size(); ++i) {
        const Stance& q = beyond.questions[i];
        CHECK(dot(q.position, q.up) == Approx(1.02).epsilon(1e-12));
        CHECK(dot(q.position, q.forward) == Approx(1.01).epsilon(1e-12));
        REQUIRE(beyond.truths[i].places.size() == 1);  // back on the rim, or on the side below it
        CHECK(dot(beyond.truths[i].places[0], q.forward) == Approx(1).epsilon(1e-12));
    }
}

TEST_CASE("kinds for which a surface has no place are left out", "[unit]") {
    // A ball has no edge that drops away under a body; walks on an open sheet turn back at its border.
    const auto round = make_questions(AskedSurface(mesh::sphere(2, 16)).surface, 1, 20);
    CHECK(std::none_of(round.begin(), round.end(), [](const auto& set) { return set.name == "over_edges"; }));
    const auto sheet = make_questions(AskedSurface(mesh::height_field(2, 4)).surface, 1, 300);
    CHECK(named(sheet, "underfoot").questions.size() == 300);
}

TEST_CASE("ways answer the kinds of questions that they are for", "[unit]") {
    using Finds = SurfaceWays::Finds;
    QuestionSet set;
    set.name = "edges";
    CHECK(set.suits(Finds::crossing));
    CHECK_FALSE(set.suits(Finds::nearest));
    CHECK_FALSE(set.suits(Finds::underfoot));
    set.name = "underfoot";
    for (const Finds finds : {Finds::crossing, Finds::nearest, Finds::underfoot}) CHECK(set.suits(finds));
    set.name = "over_edges";
    CHECK_FALSE(set.suits(Finds::crossing));
    CHECK(set.suits(Finds::nearest));
    CHECK(set.suits(Finds::underfoot));
}
