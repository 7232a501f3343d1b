#include "study/time_budget.hpp"

#include <algorithm>

namespace orbweaver::study {

namespace {

Deadline::Clock::time_point in(double seconds) {
    constexpr double kLongest = 1e8;  // three years: beyond, clocks could overflow
    return Deadline::Clock::now() + std::chrono::duration_cast<Deadline::Clock::duration>(
                                        std::chrono::duration<double>(std::min(seconds, kLongest)));
}

}  // namespace

double Deadline::left() const {
    if (interrupt_->requested()) return 0;
    return std::max(0.0, std::chrono::duration<double>(at_ - Clock::now()).count());
}

Deadline Deadline::share(double part) const { return {in(part * left()), *interrupt_}; }

Deadline deadline_in(double seconds, const Interrupt& interrupt) { return {in(seconds), interrupt}; }

}  // namespace orbweaver::study
