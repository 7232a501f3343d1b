#include "signal_blocked.hpp"

#include <ctime>

namespace orbweaver::film {

SignalBlocked::SignalBlocked(int signal) noexcept {
    sigset_t pending{};
    sigpending(&pending);
    pending_before_ = sigismember(&pending, signal) == 1;
    sigemptyset(&set_);
    sigaddset(&set_, signal);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
}

SignalBlocked::~SignalBlocked() {
    const timespec at_once{0, 0};
    if (!pending_before_) sigtimedwait(&set_, nullptr, &at_once);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

}  // namespace orbweaver::film
