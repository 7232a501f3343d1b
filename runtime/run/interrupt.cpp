#include "run/interrupt.hpp"

#include <pthread.h>

#include <ctime>

namespace orbweaver {

Interrupt::Interrupt() {
    sigemptyset(&watched_);
    sigaddset(&watched_, SIGINT);
    sigaddset(&watched_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &watched_, &before_);
}

Interrupt::~Interrupt() {
    // Take what is still waiting, or it would kill the moment it is unblocked.
    const timespec at_once{};
    while (sigtimedwait(&watched_, nullptr, &at_once) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool Interrupt::requested() const noexcept {
    sigset_t pending;
    sigpending(&pending);
    return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

}  // namespace orbweaver
