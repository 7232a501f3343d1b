#include "signal_blocked.hpp"

#include <catch2/catch.hpp>

using orbweaver::film::SignalBlocked;

TEST_CASE("a signal raised meanwhile is swallowed, and the mask is as before", "[unit]") {
    sigset_t before{};
    sigset_t after{};
    pthread_sigmask(SIG_SETMASK, nullptr, &before);
    {
        const SignalBlocked blocked(SIGXFSZ);
        raise(SIGXFSZ);  // would end the process
    }
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    CHECK(sigismember(&before, SIGXFSZ) == sigismember(&after, SIGXFSZ));
    sigset_t pending{};
    sigpending(&pending);
    CHECK(sigismember(&pending, SIGXFSZ) == 0);
}

TEST_CASE("a signal that somebody else had pending stays pending", "[unit]") {
    sigset_t set{};
    sigemptyset(&set);
    sigaddset(&set, SIGXFSZ);
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    raise(SIGXFSZ);
    { const SignalBlocked blocked(SIGXFSZ); }
    sigset_t pending{};
    sigpending(&pending);
    CHECK(sigismember(&pending, SIGXFSZ) == 1);
    const timespec at_once{0, 0};
    sigtimedwait(&set, nullptr, &at_once);
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}
