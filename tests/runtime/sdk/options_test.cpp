#include "orbweaver/options.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using orbweaver::test::fault_of;

namespace {

Options one_of_each() {
    Options options;
    options.set_table({"scene.toml", 3, 1});
    options.set("flag", true, {});
    options.set("integer", std::int64_t{-4}, {});
    options.set("number", 2.5, {"scene.toml", 5, 10});
    options.set("text", std::string("words"), {});
    options.set("vector", Vec3{1, 2, 3}, {});
    options.set("numbers", std::vector<double>{1, 2}, {});
    options.set("vectors", std::vector<Vec3>{{1, 2, 3}}, {});
    return options;
}

}  // namespace

TEST_CASE("every type of option comes back as it was set", "[unit]") {
    const Options options = one_of_each();
    CHECK(options.flag("flag"));
    CHECK(options.integer("integer") == -4);
    CHECK(options.number("number") == 2.5);
    CHECK(options.text("text") == "words");
    CHECK(options.vector("vector") == Vec3{1, 2, 3});
    CHECK(options.numbers("numbers") == std::vector<double>{1, 2});
    CHECK(options.vectors("vectors") == std::vector<Vec3>{{1, 2, 3}});
}

TEST_CASE("an option knows whether and where the scene gave it", "[unit]") {
    const Options options = one_of_each();
    CHECK(options.has("flag"));
    CHECK_FALSE(options.given("flag"));
    CHECK(to_string(options.where("flag")) == "scene.toml:3:1");
    CHECK(options.given("number"));
    CHECK(to_string(options.where("number")) == "scene.toml:5:10");
    CHECK_FALSE(options.has("nothing"));
    CHECK_FALSE(options.given("nothing"));
    CHECK(to_string(options.where("nothing")) == "scene.toml:3:1");
}

TEST_CASE("asking for an option that is not there, or as what it is not, is a fault in words", "[unit]") {
    const Options options = one_of_each();
    CHECK(fault_of([&] { options.number("nothing"); }) == "option 'nothing' has no value; ask has() first");
    CHECK(fault_of([&] { options.flag("text"); }) == "option 'text' is not declared as boolean");
    CHECK(fault_of([&] { options.integer("number"); }) == "option 'number' is not declared as integer");
    CHECK(fault_of([&] { options.number("integer"); }) == "option 'integer' is not declared as number");
    CHECK(fault_of([&] { options.text("flag"); }) == "option 'flag' is not declared as text");
    CHECK(fault_of([&] { options.vector("numbers"); }) == "option 'numbers' is not declared as vector");
    CHECK(fault_of([&] { options.numbers("vector"); }) == "option 'vector' is not declared as numbers");
    CHECK(fault_of([&] { options.vectors("vector"); }) == "option 'vector' is not declared as vectors");
    CHECK(test::kind_of_fault([&] { options.number("nothing"); }) == FaultKind::internal);
}
