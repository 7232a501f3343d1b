#include "study/ways.hpp"

#include <catch2/catch.hpp>

#include "support/study.hpp"

using namespace orbweaver;
using namespace orbweaver::study;

namespace {

/// Two kinds of tasks, of which the second has two settings; the slow way does not suit it.
class Chores final : public Contest {
public:
    const std::vector<Named>& tasks() const override { return tasks_; }
    const std::vector<Named>& ways() const override { return ways_; }
    const std::vector<std::string>& settings(std::size_t tasks) const override { return settings_[tasks]; }
    std::size_t count(std::size_t tasks) const override { return 10 * (tasks + 1); }
    bool suits(std::size_t tasks, std::size_t way) const override { return tasks == 0 || way == 0; }
    void run(std::size_t tasks, std::size_t way, std::size_t setting) override {
        last_ = {tasks, way, setting};
    }
    void judge(std::size_t tasks, std::size_t way, std::size_t setting, WayRow& row) override {
        CHECK(last_ == std::vector<std::size_t>{tasks, way, setting});
        row.missed = way;
        set_errors({1.0 + static_cast<double>(setting), 5, 3}, row);
    }

private:
    std::vector<Named> tasks_{{"wash", "the dishes"}, {"dry", "them"}};
    std::vector<Named> ways_{{"quick", "in haste"}, {"slow", "with care"}};
    std::vector<std::vector<std::string>> settings_{{""}, {"cloth", "air"}};
    std::vector<std::size_t> last_;
};

struct Studied {
    StudySettings settings;
    Interrupt interrupt;
    Chores chores;
    WaysResult result;

    Studied() {
        settings.run.quiet = true;
        settings.repeats = 1;
        result.words.name = "chores";
        result.words.doing = "doing them";
    }
    void study(double seconds = 60) { study_ways(settings, chores, deadline_in(seconds, interrupt), result); }
};

}  // namespace

TEST_CASE("every way does the tasks that suit it, at every setting, and is judged by what it did last",
          "[unit]") {
    Studied studied;
    studied.study();
    const auto& rows = studied.result.rows;
    REQUIRE(rows.size() == 4);
    const char* expected[][3] = {
        {"wash", "quick", ""}, {"wash", "slow", ""}, {"dry", "quick", "cloth"}, {"dry", "quick", "air"}};
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(rows[i].tasks == expected[i][0]);
        CHECK(rows[i].way == expected[i][1]);
        CHECK(rows[i].setting == expected[i][2]);
        CHECK(rows[i].cost_s > 0);
    }
    CHECK(rows[2].asked == 20);
    CHECK(rows[1].missed == 1);
    CHECK(rows[3].error == 5);
    CHECK(rows[3].median_error == 3);
    CHECK(studied.result.rows_of("dry").size() == 2);
    CHECK(studied.result.sentences.empty());
}

TEST_CASE("a way is chosen by its name, and one that there is not is refused", "[unit]") {
    Studied studied;
    studied.settings.methods = {"slow"};
    studied.study();
    CHECK(studied.result.rows.size() == 1);
    CHECK(studied.result.ways.size() == 1);
    studied.settings.methods = {"slwo"};
    CHECK_THROWS_WITH(
        studied.study(),
        "--method slwo: there is no such way of doing them; expected quick or slow; did you mean slow?");
}

TEST_CASE("what no time was left for is said, a way at a time", "[extreme]") {
    Studied studied;
    studied.study(1e-9);
    CHECK(studied.result.rows.empty());
    CHECK(studied.result.sentences == std::vector<std::string>{"wash by quick: left out for lack of time",
                                                               "wash by slow: left out for lack of time",
                                                               "dry by quick: left out for lack of time"});
}
