#pragma once

#include <chrono>

#include "run/interrupt.hpp"

namespace orbweaver::study {

/// A moment after which no more frames are run; a signal brings it forward to now.
class Deadline {
public:
    using Clock = std::chrono::steady_clock;

    Deadline(Clock::time_point at, const Interrupt& interrupt) : at_(at), interrupt_(&interrupt) {}

    double left() const;  ///< s, 0 when it has passed
    bool passed() const { return left() <= 0; }
    bool interrupted() const noexcept { return interrupt_->requested(); }
    /// Behind what was not done: "when interrupted", "for lack of time".
    const char* why_passed() const noexcept { return interrupted() ? "when interrupted" : "for lack of time"; }
    /// The moment when this part of what is left will have gone.
    Deadline share(double part) const;

private:
    Clock::time_point at_;
    const Interrupt* interrupt_;
};

/// The moment `seconds` from now.
Deadline deadline_in(double seconds, const Interrupt& interrupt);

}  // namespace orbweaver::study
