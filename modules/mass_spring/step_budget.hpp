#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

namespace orbweaver::mass_spring {

/// What a stretch of a run may take: steps, and parts of steps that a method divides.
class StepBudget {
public:
    /// Without end.
    StepBudget() = default;
    /// At most `most`, and none any more once `stop_asked`, where there is one, says so.
    StepBudget(std::int64_t most, std::function<bool()> stop_asked = {})
        : most_(most), stop_asked_(std::move(stop_asked)) {}

    /// Asked before a step or a part of one. False where it is not to be taken, nor any after it.
    bool take() {
        stopped_ = stopped_ || (stop_asked_ && stop_asked_());
        spent_ = spent_ || taken_ == most_;
        if (refused()) return false;
        ++taken_;
        return true;
    }

    std::int64_t most() const noexcept { return most_; }
    std::int64_t taken() const noexcept { return taken_; }
    bool stopped() const noexcept { return stopped_; }            ///< a step was refused since a stop was asked
    bool refused() const noexcept { return stopped_ || spent_; }  ///< a step was, for whatever reason

private:
    std::int64_t most_ = std::numeric_limits<std::int64_t>::max();
    std::int64_t taken_ = 0;
    bool spent_ = false;
    bool stopped_ = false;
    std::function<bool()> stop_asked_;
};

}  // namespace orbweaver::mass_spring
