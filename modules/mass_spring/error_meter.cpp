#include "error_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace orbweaver::mass_spring {

bool ErrorMeter::samples(std::uint64_t frame) noexcept {
    constexpr std::uint64_t kInterval = 64;
    return frame % kInterval == 0 || (frame < kInterval && std::has_single_bit(frame));
}

void ErrorMeter::add(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    const double power = std::ldexp(1.0, order);
    double largest = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) largest = std::max(largest, distance(whole[i], halved[i]));
    last_ = power / (power - 1) * largest;
    sum_ += last_ * static_cast<double>(frames_since_);
    frames_ += frames_since_;
    frames_since_ = 0;
    ++samples_;
}

void ErrorMeter::add_embedded(double error, std::int64_t steps) noexcept {
    sum_ += error;
    steps_ += steps;
}

double ErrorMeter::estimate() const noexcept { return sum_ + last_ * static_cast<double>(frames_since_); }

std::string ErrorMeter::how() const {
    if (steps_ > 0)
        return "embedded method: errors of single steps added up, " + std::to_string(steps_) + " steps tried";
    if (samples_ == 0) return "no frame was redone yet";
    return "step doubling: largest change of a position when a frame is redone at half the step, " +
           std::to_string(samples_) + " of " + std::to_string(frames_ + frames_since_) +
           " frames redone, errors of single frames added up";
}

}  // namespace orbweaver::mass_spring
