#include "plan/attach_order.hpp"

#include <catch2/catch.hpp>

using namespace orbweaver;

namespace {

using Texts = std::vector<std::string>;

Manifest manifest(const std::string& id, Texts provides, Texts uses) {
    Manifest made;
    made.id = id;
    made.provides = std::move(provides);
    made.uses = std::move(uses);
    return made;
}

Texts names(const AttachOrder& order) {
    Texts all;
    for (const PlannedModule& module : order.modules) all.push_back(module.instance);
    return all;
}

}  // namespace

TEST_CASE("modules stand behind all of their providers, else by name", "[unit]") {
    const Manifest web = manifest("web", {"threads/1"}, {"wind/1"});
    const Manifest wind = manifest("wind", {"wind/1"}, {});
    const Manifest view = manifest("view", {}, {"threads/1"});
    const AttachOrder order = attach_order(
        {{&view, "view", "", {}}, {&web, "web.2", "", {}}, {&web, "web", "", {}}, {&wind, "wind", "", {}}});
    CHECK(names(order) == Texts{"wind", "web", "web.2", "view"});
    CHECK(order.circle.empty());
}

TEST_CASE("a circle is named, and those outside it are placed", "[unit]") {
    const Manifest hen = manifest("hen", {"hen/1"}, {"egg/1"});
    const Manifest egg = manifest("egg", {"egg/1"}, {"hen/1"});
    const Manifest fox = manifest("fox", {}, {});
    const AttachOrder order =
        attach_order({{&hen, "hen", "", {}}, {&fox, "fox", "", {}}, {&egg, "egg", "", {}}});
    CHECK(names(order) == Texts{"fox", "egg", "hen"});
    CHECK(order.circle == Texts{"egg", "hen"});
}

TEST_CASE("one module may use what only it provides, two of them wait for each other", "[unit]") {
    const Manifest chain = manifest("chain", {"link/1"}, {"link/1"});
    CHECK(attach_order({{&chain, "chain", "", {}}}).circle.empty());
    CHECK(attach_order({{&chain, "chain", "", {}}, {&chain, "chain.2", "", {}}}).circle ==
          Texts{"chain", "chain.2"});
}

TEST_CASE("a hundred thousand modules are ordered in no time", "[extreme]") {
    const Manifest web = manifest("web", {"threads/1"}, {"wind/1"});
    const Manifest wind = manifest("wind", {"wind/1"}, {});
    std::vector<PlannedModule> modules;
    for (int i = 0; i < 100'000; ++i) modules.push_back({&web, "web." + std::to_string(i), "", {}});
    modules.push_back({&wind, "wind", "", {}});
    const AttachOrder order = attach_order(std::move(modules));
    CHECK(order.modules.front().instance == "wind");
    CHECK(order.modules.size() == 100'001);
}
