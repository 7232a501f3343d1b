#pragma once

namespace orbweaver::mass_spring {

/// Chooses steps whose errors stay within a tolerance. A step is scaled by numbers of a short ladder only:
/// where little would be won it stays as it is, so that an implicit method keeps its factorisation, and nothing
/// rests on how a library rounds powers.
class StepControl {
public:
    /// `order`: the error of a step shrinks with its length to order + 1. `tolerance` in m, of one step.
    StepControl(int order, double tolerance) noexcept : order_(order), tolerance_(tolerance) {}

    bool accepts(double error) const noexcept { return error <= tolerance_; }
    /// What to scale a step of that error by: the most that leaves the next one half the tolerance. Below 1
    /// where it is not accepted, and smallest where it is not finite.
    double scale(double error) const noexcept;

private:
    int order_;
    double tolerance_;
};

}  // namespace orbweaver::mass_spring
