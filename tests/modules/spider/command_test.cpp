#include "command.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace orbweaver::spider;

TEST_CASE("a command holds from its begin to its end, and the later of two counts", "[unit]") {
    const std::vector<TimedCommand> script{
        {0.5, std::numeric_limits<double>::infinity(), {0.1, 0}}, {1, 2, {0, 90}}, {1.5, 2, {0, -90}}};
    CHECK_FALSE(orbweaver::command_in<Command>(script, 0.49));
    CHECK(orbweaver::command_in<Command>(script, 0.5)->speed == 0.1);
    CHECK(orbweaver::command_in<Command>(script, 1)->turn == 90);
    CHECK(orbweaver::command_in<Command>(script, 1)->speed == 0);
    CHECK(orbweaver::command_in<Command>(script, 1.75)->turn == -90);
    CHECK(orbweaver::command_in<Command>(script, 2)->speed == 0.1);
    CHECK_FALSE(orbweaver::command_in<Command>({}, 1));
}

TEST_CASE("a frame that rounding puts just before a begin obeys, one just before an end does not", "[unit]") {
    const std::vector<TimedCommand> script{{0.3, 0.7, {0.1, 0}}};
    CHECK(orbweaver::command_in<Command>(script, 18 * (1.0 / 60) - 1e-16));
    CHECK_FALSE(orbweaver::command_in<Command>(script, 0.7 - 1e-15));
}

TEST_CASE("keys ask for all the speed there is, no key for nothing", "[unit]") {
    const Command fastest{0.2, 110};
    CHECK_FALSE(command_of_keys(0, 0, fastest));
    CHECK(command_of_keys(1, 0, fastest)->speed == 0.2);
    CHECK(command_of_keys(-1, 0, fastest)->speed == -0.2);
    CHECK(command_of_keys(0, 1, fastest)->turn == 110);
    CHECK(command_of_keys(1, -1, fastest)->turn == -110);
}
