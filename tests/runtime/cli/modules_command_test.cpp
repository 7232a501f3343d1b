#include "cli/modules_command.hpp"

#include <catch2/catch.hpp>

#include "support/program.hpp"

using namespace orbweaver::test;

TEST_CASE("the modules found are listed with version, summary and place", "[scene]") {
    const Outcome outcome =
        run_program({"modules", "--modules", fixture("counter"), "--modules", fixture("diverges")});
    CHECK(outcome.code == 0);
    CHECK_THAT(
        outcome.out,
        Catch::Contains("counter          1.2.3    A good module: counts frames, walks at random, and has an "
                        "option of every type\n" +
                        std::string(26, ' ') + fixture("counter") + "/counter.so\n") &&
            Catch::Contains("diverges         1        Doubles a number") &&
            Catch::Contains("\nsearched: " + fixture("counter") + ", " + fixture("diverges") + ", "));
}

TEST_CASE("one module is shown in full, its options with unit, range and default", "[scene]") {
    const Outcome outcome = run_program({"modules", "counter", "--modules", fixture("counter")});
    CHECK(outcome.code == 0);
    for (const char* line :
         {"  table    [counter], or several [[counter]]\n", "  provides tally/1\n",
          "  phases   integrate, derive, present\n",
          "stride                       length of a step of the walk (number of m, above 0 and at most 1; "
          "default \"5 "
          "mm\")\n",
          "start                        where counting begins (integer, at least 0 and at most 1000; default "
          "0)\n",
          "mode                         direction of counting (choice: up or down; default \"up\")\n",
          "nested.delay                 time to sleep in each frame, of the wall clock (number of s, at least "
          "0; default "
          "0)\n",
          "origin                       where the walk begins (vector of m; default [0, 0, 0])\n",
          "table                        a file that it only names (file; no default)\n"}) {
        CAPTURE(line);
        CHECK_THAT(outcome.out, Catch::Contains(line));
    }
    CHECK_THAT(run_program({"modules", "thrower", "--modules", fixture("thrower")}).out,
               Catch::Contains("; required)\n"));
    CHECK_THAT(run_program({"modules", "scene"}).out,
               Catch::Contains("duration") && Catch::Contains("number of s"));
}

TEST_CASE("a module that is not there is refused with those that are and where they were sought", "[extreme]") {
    const Outcome outcome = run_program({"modules", "cuonter", "--modules", fixture("counter")});
    CHECK(outcome.code == 3);
    CHECK(outcome.out == "");
    CHECK_THAT(outcome.err, Catch::StartsWith("there is no module 'cuonter'; expected one of ") &&
                                Catch::Contains("searched " + fixture("counter")));
}

TEST_CASE("a broken manifest does not hide the others", "[extreme]") {
    const Folder folder;
    folder.write("broken.toml", "id = 3\n");
    const Outcome outcome =
        run_program({"modules", "--modules", folder.path(), "--modules", fixture("counter")});
    CHECK(outcome.code == 3);
    CHECK_THAT(outcome.err, Catch::Contains(folder.path("broken.toml") + ":1:6: 'id' is 3; expected a text\n"));
    CHECK_THAT(outcome.out, Catch::Contains("counter          1.2.3"));
}
