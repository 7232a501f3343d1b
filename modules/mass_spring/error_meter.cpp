#include "error_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace orbweaver::mass_spring {
namespace {

double largest_distance(std::span<const Vec3> a, std::span<const Vec3> b) noexcept {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, distance(a[i], b[i]));
    return largest;
}

}  // namespace

bool ErrorMeter::wants(std::uint64_t frame) const noexcept {
    constexpr std::uint64_t kInterval = 64;
    return samples_ == 0 || frame % kInterval == 0 || (frame < kInterval && std::has_single_bit(frame));
}

void ErrorMeter::add(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    const double power = std::ldexp(1.0, order);
    add_sample(power / (power - 1) * largest_distance(whole, halved));
}

void ErrorMeter::add_judged(std::span<const Vec3> x, std::span<const Vec3> judged_x, std::span<const Vec3> v,
                            std::span<const Vec3> judged_v, double frame_step) noexcept {
    add_sample(largest_distance(x, judged_x) + frame_step * largest_distance(v, judged_v));
}

void ErrorMeter::add_unknown() noexcept { add_sample(std::numeric_limits<double>::infinity()); }

void ErrorMeter::add_sample(double error) noexcept {
    last_ = error;
    sum_ += last_ * static_cast<double>(frames_since_);
    frames_ += frames_since_;
    frames_since_ = 0;
    ++samples_;
}

void ErrorMeter::add_embedded(double error, std::int64_t steps) noexcept {
    sum_ += error;
    steps_ += steps;
}

double ErrorMeter::estimate() const noexcept {
    return frames_since_ == 0 ? sum_ : sum_ + last_ * static_cast<double>(frames_since_);
}

std::string ErrorMeter::how() const {
    if (steps_ > 0)
        return "embedded method: errors of single steps added up, " + std::to_string(steps_) + " steps tried";
    if (samples_ == 0) return "no frame was redone yet";
    const std::string means =
        judge_.empty() ? "step doubling: largest change of a position when a frame is redone at half the step, "
                       : "another method: largest change of a position when a frame is redone by " +
                             std::string(judge_) + ", ";
    return means + std::to_string(samples_) + " of " + std::to_string(frames_ + frames_since_) +
           " frames redone, errors of single frames added up";
}

}  // namespace orbweaver::mass_spring
