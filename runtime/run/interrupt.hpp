#pragma once

#include <signal.h>

namespace orbweaver {

/// While one lives, SIGINT and SIGTERM wait to be asked for instead of killing, so that a run that is
/// interrupted still completes its files. A second signal is not special: SIGQUIT kills at once.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    bool requested() const noexcept;

private:
    sigset_t watched_;
    sigset_t before_;
};

}  // namespace orbweaver
