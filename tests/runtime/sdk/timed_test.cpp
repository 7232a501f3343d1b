#include "orbweaver/timed.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace orbweaver;

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

struct Command {
    double pace = 1, turn = 0;
};
using TimedCommand = Timed<Command>;

}  // namespace

TEST_CASE("a script holds from its begin until before its end, and of two the later one", "[unit]") {
    const TimedCommand script[] = {{0.5, 1.5, {1, 0.25}}, {1, 1.25, {-1, 0}}, {3, kForever, {0, -1}}};
    CHECK_FALSE(command_in<Command>(script, 0.4999));
    CHECK(command_in<Command>(script, 0.5)->turn == 0.25);
    CHECK(command_in<Command>(script, 0.5 - 1e-12)->turn == 0.25);  // frames' times are rounded
    CHECK(command_in<Command>(script, 1)->pace == -1);
    CHECK(command_in<Command>(script, 1.25)->pace == 1);
    CHECK_FALSE(command_in<Command>(script, 1.5));
    CHECK_FALSE(command_in<Command>(script, 1.5 - 1e-12));
    CHECK(command_in<Command>(script, 1e9)->turn == -1);
    CHECK_FALSE(command_in<Command>({}, 0));
}
