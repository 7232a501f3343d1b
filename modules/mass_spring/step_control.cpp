#include "step_control.hpp"

#include <array>

namespace orbweaver::mass_spring {

double StepControl::scale(double error) const noexcept {
    static constexpr std::array<double, 11> kLadder{5, 3, 2, 1.5, 1.2, 1, 0.85, 0.7, 0.5, 0.35, 0.2};
    for (const double rung : kLadder) {
        if (rung >= 1 && !accepts(error)) continue;
        double there = error;
        for (int i = 0; i <= order_; ++i) there *= rung;
        if (there <= tolerance_ / 2) return rung;
    }
    return kLadder.back();
}

}  // namespace orbweaver::mass_spring
