#include "run/interrupt.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

using namespace orbweaver;

namespace {

using std::chrono::milliseconds;

void wait_for(const Interrupt& interrupt) {
    while (!interrupt.requested()) std::this_thread::sleep_for(milliseconds(1));
}

/// The signal that ended a process which got `signal` twice, `apart` from each other; 0 when it went on.
int ended_by(int signal, milliseconds apart) {
    const pid_t child = ::fork();
    if (child == 0) {
        const Interrupt interrupt;
        ::kill(::getpid(), signal);
        wait_for(interrupt);
        std::this_thread::sleep_for(apart);
        ::kill(::getpid(), signal);
        std::this_thread::sleep_for(milliseconds(500));
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("a signal waits to be asked for, and is gone afterwards", "[unit]") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        {
            const Interrupt interrupt;
            CHECK_FALSE(interrupt.requested());
            ::kill(::getpid(), signal);
            wait_for(interrupt);
            ::kill(::getpid(), signal);
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

TEST_CASE("a second signal ends the process, unless it is the first one's echo", "[extreme]") {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        CAPTURE(signal);
        CHECK(ended_by(signal, milliseconds(600)) == signal);
        CHECK(ended_by(signal, milliseconds(0)) == 0);
    }
}

TEST_CASE("a signal that the process was started to ignore stays ignored", "[unit]") {
    const auto before = ::signal(SIGHUP, SIG_IGN);
    {
        const Interrupt interrupt;
        ::kill(::getpid(), SIGHUP);
        std::this_thread::sleep_for(milliseconds(50));
        CHECK_FALSE(interrupt.requested());
    }
    ::signal(SIGHUP, before);
}
