#include "lost_vibrations.hpp"

#include <cmath>

namespace orbweaver::mass_spring {

bool LostVibrations::samples(std::uint64_t frame) noexcept {
    constexpr std::uint64_t kInterval = 64;
    return frame % kInterval <= 1;
}

void LostVibrations::add(double whole, double halved, double rounding) noexcept {
    constexpr double kLostAlike = 2.0 / 3;  // order one halves what it loses, higher orders more than that
    const bool lost = halved > rounding && halved > kLostAlike * whole;
    last_ = lost ? halved : 0;
    energy_ += last_ * static_cast<double>(frames_since_);
    frames_since_ = 0;
}

double LostVibrations::amplitude(double mass, double omega) const noexcept {
    return energy() > 0 ? std::sqrt(2 * energy() / mass) / omega : 0;
}

}  // namespace orbweaver::mass_spring
