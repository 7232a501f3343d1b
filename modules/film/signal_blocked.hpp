#pragma once

#include <csignal>

namespace orbweaver::film {

/// Keeps one signal from the calling thread for as long as it lives, and swallows what came meanwhile, so
/// that a write over the file size limit is an error to report rather than the process's end. The
/// process's own handlers stay as they are.
class SignalBlocked {
public:
    explicit SignalBlocked(int signal) noexcept;
    SignalBlocked(const SignalBlocked&) = delete;
    SignalBlocked& operator=(const SignalBlocked&) = delete;
    ~SignalBlocked();

private:
    sigset_t set_{};
    sigset_t before_{};
    bool pending_before_ = false;
};

}  // namespace orbweaver::film
