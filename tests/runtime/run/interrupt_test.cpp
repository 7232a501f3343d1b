#include "run/interrupt.hpp"

#include <signal.h>

#include <catch2/catch.hpp>

using namespace orbweaver;

TEST_CASE("a signal waits to be asked for, and is gone afterwards", "[unit]") {
    for (const int signal : {SIGINT, SIGTERM}) {
        CAPTURE(signal);
        {
            const Interrupt interrupt;
            CHECK_FALSE(interrupt.requested());
            ::raise(signal);
            CHECK(interrupt.requested());
            ::raise(signal);
            CHECK(interrupt.requested());
        }
        sigset_t mask;
        sigset_t pending;
        ::pthread_sigmask(SIG_BLOCK, nullptr, &mask);
        ::sigpending(&pending);
        CHECK(sigismember(&mask, signal) == 0);
        CHECK(sigismember(&pending, signal) == 0);
        const Interrupt again;
        CHECK_FALSE(again.requested());
    }
}
