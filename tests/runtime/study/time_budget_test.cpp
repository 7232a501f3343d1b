#include "study/time_budget.hpp"

#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <thread>

using namespace orbweaver;
using namespace orbweaver::study;

TEST_CASE("a deadline passes, and its share before it", "[unit]") {
    const Interrupt interrupt;
    const Deadline deadline = deadline_in(100, interrupt);
    CHECK_FALSE(deadline.passed());
    CHECK(deadline.left() == Approx(100).margin(5));
    CHECK(deadline.share(0.25).left() == Approx(25).margin(5));
    CHECK(deadline_in(0, interrupt).passed());
    CHECK(deadline_in(1e300, interrupt).left() > 1e7);
}

TEST_CASE("a signal brings every deadline forward to now", "[unit]") {
    const Interrupt interrupt;
    const Deadline deadline = deadline_in(100, interrupt);
    ::kill(::getpid(), SIGINT);
    for (int i = 0; i < 500 && !deadline.passed(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    CHECK(deadline.passed());
    CHECK(deadline.interrupted());
}
