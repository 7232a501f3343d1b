#include "run/instance.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

std::string opening_fault(const std::string& scene, const std::vector<std::string>& fixtures) {
    return fault_of([&] { OpenedScene opened(scene, fixtures); });
}

}  // namespace

TEST_CASE("what a module throws while attaching comes out as a sentence with its name", "[extreme]") {
    struct Case {
        const char* what;
        const char* sentence;
        FaultKind kind;
    };
    const Case cases[] = {
        {"fault", "module 'thrower' failed while attaching: the well is dry; dig deeper", FaultKind::limit},
        {"exception", "module 'thrower' failed while attaching: a plain exception", FaultKind::internal},
        {"integer", "module 'thrower' failed while attaching: threw something that is not a std::exception",
         FaultKind::internal},
        {"memory",
         "module 'thrower' failed while attaching: out of memory; ask for less, or give the process more",
         FaultKind::limit},
    };
    for (const Case& c : cases) {
        const std::string scene = "[thrower]\nwhere = \"attach\"\nwhat = \"" + std::string(c.what) + "\"\n";
        CHECK(opening_fault(scene, {"thrower"}) == c.sentence);
        CHECK(kind_of_fault([&] { OpenedScene opened(scene, {"thrower"}); }) == c.kind);

        const Folder folder;
        const Outcome outcome =
            run_program({"run", folder.write("scene.toml", scene), "--quiet", "--modules", fixture("thrower")});
        CHECK(outcome.code == static_cast<int>(c.kind));
        CHECK(outcome.err == "error: " + std::string(c.sentence) + "\n");
    }
}

TEST_CASE("what a module throws later names the call, the frame and the phase", "[extreme]") {
    struct Case {
        const char* where;
        const char* sentence;
    };
    const Case cases[] = {
        {"sense", "module 'thrower' failed in frame 0, phase sense: the well is dry; dig deeper"},
        {"derive", "module 'thrower' failed in frame 0, phase derive: the well is dry; dig deeper"},
        {"present", "module 'thrower' failed in frame 1, phase present: the well is dry; dig deeper"},
        {"restored", "module 'thrower' failed while taking up a restored state: the well is dry; dig deeper"},
        {"report", "module 'thrower' failed while reporting: the well is dry; dig deeper"},
        {"finish", "module 'thrower' failed while finishing: the well is dry; dig deeper"},
    };
    for (const Case& c : cases) {
        const OpenedScene opened("[thrower]\nwhere = \"" + std::string(c.where) + "\"\n", {"thrower"});
        CHECK(fault_of([&] {
                  opened.run(1);
                  opened.session->present();
                  opened.session->instances().front()->restored();
                  opened.session->instances().front()->report();
                  opened.session->finish();
              }) == c.sentence);
    }
}

TEST_CASE("what a module throws while it meets the others ends the opening", "[extreme]") {
    CHECK(opening_fault("[thrower]\nwhere = \"meet\"\n", {"thrower"}) ==
          "module 'thrower' failed while meeting the others: the well is dry; dig deeper");
}

TEST_CASE("a module whose constructor throws is refused by name", "[extreme]") {
    const char* sentence = "module 'throws_in_constructor' cannot be made: no ground to stand on";
    CHECK(opening_fault("[throws_in_constructor]\n", {"throws_in_constructor"}) == sentence);
    try {
        OpenedScene opened("[throws_in_constructor]\n", {"throws_in_constructor"});
    } catch (const LoadError& error) {
        CHECK(error.fault() == LoadFault::cannot_create);
    }
}

TEST_CASE("a contract that is promised must be provided, by every instance", "[extreme]") {
    CHECK(opening_fault("[breaks_promise]\n", {"breaks_promise"}) ==
          "module 'breaks_promise' did not provide tally/1, which its manifest promises");
    // Another module's promise, kept, does not count for this one: instances attach by name.
    CHECK(opening_fault("[breaks_promise]\n[counter]\n", {"breaks_promise", "counter"}) ==
          "module 'breaks_promise' did not provide tally/1, which its manifest promises");
    CHECK(
        opening_fault("[[breaks_promise]]\n[[breaks_promise]]\n[[counter]]\n", {"breaks_promise", "counter"}) ==
        "module 'breaks_promise' did not provide tally/1, which its manifest promises");
}

TEST_CASE("a contract that is provided must be promised", "[extreme]") {
    CHECK(
        opening_fault("[unpromised]\n", {"unpromised"}) ==
        "module 'unpromised' failed while attaching: it provides tally/1, which its manifest does not promise");
}

TEST_CASE("an instance offers its options, state, telemetry and report", "[unit]") {
    const OpenedScene opened("[[counter]]\n[[counter]]\nstart = 7\nmode = \"down\"\n", {"counter"});
    REQUIRE(opened.session->instances().size() == 2);
    Instance& second = *opened.session->instances()[1];
    CHECK(second.instance_name() == "counter.2");
    CHECK(second.manifest().id == "counter");
    CHECK(second.takes_part_in(Phase::integrate));
    CHECK_FALSE(second.takes_part_in(Phase::sense));
    REQUIRE(second.telemetry_columns().size() == 1);
    opened.run(3);
    const ModuleReport report = second.report();
    CHECK(report.method == "counting");
    CHECK(report.steps == 4);
    CHECK(report.measures.size() == 5);
    CHECK(second.wall_seconds() > 0);
    CHECK(second.block().entries().size() == 3);
}
