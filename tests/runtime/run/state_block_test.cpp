#include "run/state_block.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;

TEST_CASE("state arrays begin at zero and stay where they are", "[unit]") {
    StateBlock block;
    const auto places = block.vectors("place", 3, {"m", "places", true});
    const auto first = places.data();
    const auto masses = block.scalars("mass", 2, {"kg", "masses", false});
    for (int i = 0; i < 100; ++i) block.words("word" + std::to_string(i), 1, {"1", "", true});
    CHECK(places[2] == Vec3{});
    CHECK(masses[1] == 0);
    CHECK(block.bytes() == 3 * 24 + 2 * 8 + 100 * 8);
    places[0].x = 5;
    CHECK(block.entries().front().memory() == first);
    CHECK(*static_cast<const double*>(block.entries().front().memory()) == 5);
    CHECK(block.entries().front().count() == 3);
    CHECK(block.entries().front().bytes() == 72);
    CHECK(block.entries()[1].info.unit == "kg");
    CHECK_FALSE(block.entries()[1].info.record);
}

TEST_CASE("an array may be empty, and may not be made twice", "[extreme]") {
    StateBlock block;
    CHECK(block.vectors("none", 0, {}).empty());
    CHECK(block.bytes() == 0);
    CHECK(test::fault_of([&] { block.scalars("none", 1, {}); }) == "state array 'none' was made twice");
}
