#include "study/queries.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "support/asked_surface.hpp"
#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// Two ways that are wrong on purpose: one finds nothing, one finds the same place always.
class BadWays final : public SurfaceWays {
public:
    std::span<const Way> ways() const noexcept override {
        static constexpr Way kWays[] = {{"blind", "finds nothing", Finds::crossing},
                                        {"stubborn", "finds one place", Finds::crossing}};
        return kWays;
    }
    void answer(std::size_t way, std::span<const Stance> questions,
                std::span<SurfaceHit> hits) const noexcept override {
        for (std::size_t i = 0; i < questions.size(); ++i) {
            hits[i] = {};
            if (way == 1) hits[i].answer = Answer::found;
            if (way == 1) hits[i].at = {0, {1, 0, 0}};
        }
    }
};

struct Asked {
    AskedSurface cube{mesh::cube(2, 3)};
    StudySettings settings;
    Interrupt interrupt;

    Asked() {
        settings.run.quiet = true;
        settings.repeats = 1;
    }
    WaysResult study(const std::vector<SurfaceWays*>& offers, double seconds = 60) {
        return study_queries(settings, "a cube", 7, cube.surface, offers, deadline_in(seconds, interrupt));
    }
};

}  // namespace

TEST_CASE("every way is asked what it answers, and errors are as small as doubles are", "[scene]") {
    Asked asked;
    const WaysResult result = asked.study({&asked.cube.ways});
    CHECK(result.facts == std::vector<Fact>{{"triangles", 108U}, {"size_m", 2.0}, {"seed", 7U}});
    CHECK(result.rows.size() == 3 * 2 + 4 + 2);
    for (const WayRow& row : result.rows) {
        CAPTURE(row.tasks, row.way);
        CHECK(row.asked == 2000);
        CHECK(row.missed == 0);
        CHECK(row.invented == 0);
        CHECK(row.cost_s > 0);
        CHECK(row.median_error <= row.error);
        const bool is_scan = row.tasks == "over_edges" && row.way == "walker";
        CHECK(row.error < (is_scan ? 0.1 : 1e-12));
    }
    CHECK(result.sentences.size() == 5);
    CHECK_THAT(result.sentences[1], Catch::StartsWith("vertices: 2000 rays at vertices: none missed"));
}

TEST_CASE("what misses, invents and errs is told", "[unit]") {
    Asked asked;
    BadWays bad;
    const WaysResult result = asked.study({&bad});
    const auto rows = result.rows_of("random");
    REQUIRE(rows.size() == 2);
    CHECK(rows[0].way == "blind");
    CHECK(rows[0].missed > 1000);
    CHECK(rows[0].invented == 0);
    CHECK(rows[1].missed == 0);
    CHECK(rows[1].missed + rows[1].invented + rows[0].missed ==
          2000);                                                    // what is not there, the other is right of
    CHECK(rows[1].error == Approx(std::sqrt(12.0)).epsilon(0.05));  // from corner to corner
    CHECK_THAT(result.sentences[0],
               Catch::Contains("blind misses ") && Catch::Contains("stubborn misses 0 and"));
}

TEST_CASE("ways are chosen by name, and one that is not there is refused with the nearest", "[unit]") {
    Asked asked;
    asked.settings.methods = {"wide_tree"};
    for (const WayRow& row : asked.study({&asked.cube.ways}).rows) CHECK(row.way == "wide_tree");
    asked.settings.methods = {"wide_tre"};
    CHECK_THROWS_WITH(asked.study({&asked.cube.ways}),
                      "--method wide_tre: there is no such way of asking; expected walker, wide_tree, "
                      "every_triangle or closest_point; did you mean wide_tree?");
}

TEST_CASE("what there was no time for is told", "[extreme]") {
    Asked asked;
    const WaysResult result = asked.study({&asked.cube.ways}, 1e-9);
    CHECK(result.rows.empty());
    REQUIRE(result.sentences.size() == 12);
    CHECK(result.sentences[0] == "random by wide_tree: left out for lack of time");
}
