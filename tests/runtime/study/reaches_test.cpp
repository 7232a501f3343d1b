#include "study/reaches.hpp"

#include <catch2/catch.hpp>

#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

/// One way that ends where its tolerance lets it, one that stops at 1e-3 and knows it, one that does not.
class Arms final : public ReachWays {
public:
    std::size_t limbs() const noexcept override { return 2; }
    std::span<const Named> ways() const noexcept override {
        static constexpr Named kWays[] = {
            {"exact", "to the point"}, {"short", "falls short"}, {"proud", "and boasts"}};
        return kWays;
    }
    std::span<const Named> kinds() const noexcept override {
        static constexpr Named kKinds[] = {{"near", "near by"}};
        return kKinds;
    }
    std::size_t count(std::size_t) const noexcept override { return 4; }
    void reach(std::size_t way, std::size_t, const Effort& effort, std::span<Reach> reaches) override {
        for (Reach& each : reaches) {
            const double reached = effort.steps > 0 ? 1.0 / effort.steps : effort.tolerance;
            each = {way == 0 ? reached : std::max(1e-3, reached), way != 1};
        }
    }
};

}  // namespace

TEST_CASE("ways of reaching are held against targets over tolerances and over steps", "[unit]") {
    StudySettings settings;
    settings.run.quiet = true;
    settings.repeats = 1;
    const Interrupt interrupt;
    Arms arms;
    const WaysResult result = study_reaches(settings, "arms", arms, deadline_in(60, interrupt));
    REQUIRE(result.tasks.size() == 2);
    CHECK(result.tasks[1].name == "near_steps");
    CHECK(result.words.title == "reach of 2 limbs");
    const auto row = [&](const std::string& way, const std::string& setting) {
        for (const WayRow& each : result.rows)
            if (each.way == way && each.setting == setting) return each;
        FAIL(way << " " << setting);
        return WayRow{};
    };
    CHECK(row("exact", "tolerance 1e-06").error == 1e-6);
    CHECK(row("exact", "tolerance 1e-06").missed == 0);
    CHECK(row("exact", "1 step").error == 1);
    CHECK(row("exact", "8 steps").error == 0.125);
    CHECK(row("exact", "8 steps").missed == 0);  // no tolerance was asked for
    CHECK(row("short", "tolerance 1e-03").missed == 0);
    CHECK(row("short", "tolerance 1e-04").missed == 4);
    CHECK(row("short", "tolerance 1e-04").invented == 0);
    CHECK(row("proud", "tolerance 1e-04").missed == 0);
    CHECK(row("proud", "tolerance 1e-04").invented == 4);
    REQUIRE(result.sentences.size() == 5);
    CHECK_THAT(result.sentences[0], Catch::StartsWith("near: within 1e-02 of a limb's length: ") &&
                                        Catch::Contains("short ") && !Catch::Contains("not "));
    CHECK_THAT(result.sentences[1], Catch::StartsWith("near: within 1e-04 of a limb's length: exact ") &&
                                        Catch::EndsWith("; not short (4 of 4 missed), proud (4 of 4 missed)"));
    CHECK_THAT(result.sentences[4],
               Catch::StartsWith("said to be reached, and not: proud at tolerance 1e-04, near: 4 of 4; "));
}
