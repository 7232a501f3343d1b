#include "network.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <limits>

#include "bodies.hpp"

using bodies::Body;
using namespace orbweaver::mass_spring;

namespace {

Body sound_pair() {
    Body body;
    body.add({0, 0, 0}, 1);
    body.add({1, 0, 0}, 1);
    body.join(0, 1, 1, 1);
    return body;
}

}  // namespace

TEST_CASE("a sound network has no faults", "[unit]") {
    const Body body = sound_pair();
    CHECK(validate(body.network, body.x).empty());
}

TEST_CASE("every fault of a network is named in words", "[unit]") {
    struct Case {
        const char* name;
        std::function<void(Body&)> spoil;
        const char* message;
    };
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    const Case cases[] = {
        {"no particles", [](Body& b) { b = {}; }, "the network has no particles"},
        {"flags missing", [](Body& b) { b.network.fixed.pop_back(); },
         "the network has 2 masses but 1 fixed flags; expected one of each"},
        {"positions missing", [](Body& b) { b.x.pop_back(); },
         "the network has 2 masses but 1 positions; expected one of each"},
        {"negative mass", [](Body& b) { b.network.mass[1] = -0.5; },
         "particle 1 has a mass of -0.5 kg; expected a finite mass above 0"},
        {"no mass", [](Body& b) { b.network.mass[0] = 0; },
         "particle 0 has a mass of 0 kg; expected a finite mass above 0"},
        {"infinite mass", [](Body& b) { b.network.mass[0] = HUGE_VAL; },
         "particle 0 has a mass of inf kg; expected a finite mass above 0"},
        {"position not a number", [](Body& b) { b.x[1].y = kNan; },
         "particle 1 has a position that is not finite; expected three finite metres"},
        {"index out of range", [](Body& b) { b.network.springs[0].b = 7; },
         "spring 0 ends at particle 7; expected an index below 2"},
        {"spring to itself", [](Body& b) { b.network.springs[0].b = 0; },
         "spring 0 joins particle 0 to itself; expected two different particles"},
        {"spring of no length", [](Body& b) { b.x[1] = b.x[0]; },
         "spring 0 has no length: particles 0 and 1 are at the same point, so its direction is undefined; "
         "move one of them"},
        {"negative rest length", [](Body& b) { b.network.springs[0].rest_length = -1; },
         "spring 0 has a rest length of -1 m; expected a finite one of at least 0"},
        {"negative stiffness", [](Body& b) { b.network.springs[0].stiffness = -2; },
         "spring 0 has a stiffness of -2 N/m; expected a finite one of at least 0"},
        {"infinite damping", [](Body& b) { b.network.springs[0].damping = HUGE_VAL; },
         "spring 0 has a damping of inf N s/m; expected a finite one of at least 0"},
    };
    for (const Case& each : cases) {
        INFO(each.name);
        Body body = sound_pair();
        each.spoil(body);
        const auto faults = validate(body.network, body.x);
        REQUIRE_FALSE(faults.empty());
        CHECK(faults.front().sentence == each.message);
    }
}

TEST_CASE("all faults of a network are found at once, each with its element", "[unit]") {
    Body body = sound_pair();
    body.network.mass[1] = -1;
    body.network.springs[0].b = 9;
    body.network.springs[0].stiffness = -1;
    const auto faults = validate(body.network, body.x);
    REQUIRE(faults.size() == 3);
    CHECK(faults[0].element == NetworkFault::Element::particle);
    CHECK(faults[0].index == 1);
    CHECK(faults[1].element == NetworkFault::Element::spring);
    CHECK(faults[2].element == NetworkFault::Element::spring);
}

TEST_CASE("parts that no spring joins are counted", "[unit]") {
    Body body = sound_pair();
    CHECK(count_parts(body.network) == 1);
    body.add({2, 0, 0}, 1);
    body.add({3, 0, 0}, 1);
    CHECK(count_parts(body.network) == 3);
    body.join(2, 3, 1, 1);
    CHECK(count_parts(body.network) == 2);
    body.join(3, 0, 1, 1);
    CHECK(count_parts(body.network) == 1);
    CHECK(count_parts(Network{}) == 0);
}
