#include "plan/study_spec.hpp"

#include <catch2/catch.hpp>

#include "plan/manifest.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

const std::string kOptions = R"(id = "a"
version = "1"
[options.method]
type = "choice"
choices = ["one", "two", "three"]
meaning = "m"
[options.step]
type = "number"
meaning = "m"
[options.tolerance]
type = "number"
meaning = "m"
[options.on_unstable]
type = "choice"
choices = ["substep", "as_asked"]
meaning = "m"
)";

const std::string kNames =
    "[study]\nmethod = \"method\"\nstep = \"step\"\non_unstable = \"on_unstable\"\naxis = \"step\"\n";

std::vector<std::string> faults_of(const std::string& study) {
    Diagnostics faults;
    CHECK_FALSE(parse_manifest(kOptions + study, "m.toml", faults));
    return sentences(faults);
}

}  // namespace

TEST_CASE("a manifest says how its module can be studied", "[unit]") {
    Diagnostics faults;
    const auto manifest = parse_manifest(kOptions + kNames +
                                             "tolerance = \"tolerance\"\nsteps = [\"one\", \"two\"]\n"
                                             "tolerances = [\"three\"]\nreferences = [\"three\", \"one\"]\n"
                                             "numerics = [\"step\"]\nautomatic = [\"tolerance\"]\n",
                                         "m.toml", faults);
    REQUIRE(manifest);
    REQUIRE(manifest->study);
    CHECK(manifest->study->method == "method");
    CHECK(manifest->study->step == "step");
    CHECK(manifest->study->tolerance == "tolerance");
    CHECK(manifest->study->on_unstable == "on_unstable");
    CHECK(manifest->study->axis == "step");
    CHECK(manifest->study->numerics == std::vector<std::string>{"step"});
    CHECK(manifest->study->automatic == std::vector<std::string>{"tolerance"});
    CHECK(manifest->study->steps == std::vector<std::string>{"one", "two"});
    CHECK(manifest->study->tolerances == std::vector<std::string>{"three"});
    CHECK(manifest->study->references == std::vector<std::string>{"three", "one"});
    CHECK_FALSE(parse_manifest(kOptions, "m.toml", faults)->study);
}

TEST_CASE("a study that its module cannot keep is a fault of the manifest", "[extreme]") {
    const std::string good = "steps = [\"one\", \"two\"]\nreferences = [\"one\", \"two\"]\n";
    CHECK(faults_of("[study]\n" + good) ==
          std::vector<std::string>{
              "m.toml:17:1: study.step is \"\"; expected the name of an option of type number",
              "m.toml:17:1: study.axis is \"\"; expected the name of an option of type number",
              "m.toml:17:1: study.on_unstable is \"\"; expected the name of an option of type choice",
              "m.toml:17:1: study.method is \"\"; expected the name of an option of type choice"});
    CHECK(faults_of(kNames + "steps = [\"one\", \"four\"]\nreferences = [\"one\", \"one\"]\n") ==
          std::vector<std::string>{
              "m.toml:17:1: study.steps names \"four\", which is no choice of its option; "
              "expected one, two or three",
              "m.toml:17:1: study.references is \"one, one\"; expected two different methods "
              "of steps and tolerances"});
    CHECK(faults_of(kNames + good + "tolerances = [\"three\"]\n") ==
          std::vector<std::string>{
              "m.toml:17:1: study.tolerance is \"\"; expected the name of an option of type number"});
    CHECK(faults_of(kNames + good + "numerics = [\"solver\"]\n") ==
          std::vector<std::string>{"m.toml:17:1: study.numerics names \"solver\"; expected names of options"});
    CHECK(faults_of(kNames + good + "color = 3\n").size() == 1);
}

TEST_CASE("a study that is no table is a fault", "[extreme]") {
    Diagnostics faults;
    CHECK_FALSE(parse_manifest("id = \"a\"\nversion = \"1\"\nstudy = 3\n", "m.toml", faults));
    CHECK(sentences(faults) == std::vector<std::string>{"m.toml:3:9: 'study' is 3; expected a table"});
}
