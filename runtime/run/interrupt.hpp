#pragma once

#include <signal.h>

#include <atomic>
#include <thread>

namespace orbweaver {

/// While one lives, the first SIGINT, SIGTERM or SIGHUP waits to be asked for instead of killing, so that a run
/// that is interrupted still completes its files; the next one ends the process at once. Signals within 0.3 s
/// of the first count as the same (some senders reach a process twice), and what was ignored stays ignored.
/// To be made before any other thread, which then inherits that these signals are not for it.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool requested() const noexcept { return requested_; }

private:
    void watch();

    sigset_t watched_;
    sigset_t before_;
    int signals_ = -1;  ///< readable when one of the watched came
    int over_ = -1;     ///< readable when this is to end
    std::atomic<bool> requested_ = false;
    std::thread watcher_;
};

}  // namespace orbweaver
