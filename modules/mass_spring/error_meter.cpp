#include "error_meter.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace orbweaver::mass_spring {
namespace {

double richardson(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    const double power = std::ldexp(1.0, order);
    return power / (power - 1) * largest_distance(whole, halved);
}

}  // namespace

bool ErrorMeter::wants(std::uint64_t frame) const noexcept {
    constexpr std::uint64_t kInterval = 64;
    return samples_ == 0 || frame % kInterval == 0 || (frame < kInterval && std::has_single_bit(frame));
}

void ErrorMeter::add(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    add_sample(richardson(whole, halved, order));
}

void ErrorMeter::follow(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    left_ = richardson(whole, halved, order);
    damped_ = std::max(damped_, last_ - left_);
}

void ErrorMeter::add_alone(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    latest_ = richardson(whole, halved, order);
    alone_ += latest_;
    if (frames_since_ > 0) --frames_since_;
    ++frames_;
    ++alone_samples_;
}

void ErrorMeter::follow_alone(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept {
    drift_ += std::max(0.0, richardson(whole, halved, order) - latest_);
}

void ErrorMeter::add_judged(std::span<const Vec3> x, std::span<const Vec3> judged_x, std::span<const Vec3> v,
                            std::span<const Vec3> judged_v, double frame_step) noexcept {
    add_sample(largest_distance(x, judged_x) + frame_step * largest_distance(v, judged_v));
}

void ErrorMeter::add_unknown() noexcept {
    ++unknown_;
    add_sample(std::numeric_limits<double>::infinity());
}

void ErrorMeter::add_sample(double error) noexcept {
    sum_ += left_ * static_cast<double>(last_frames_);
    last_ = left_ = error;
    last_frames_ = frames_since_;
    frames_ += frames_since_;
    frames_since_ = 0;
    ++samples_;
}

double ErrorMeter::estimate() const noexcept {
    const std::uint64_t frames = last_frames_ + frames_since_;
    if (samples_ == 0) return std::numeric_limits<double>::quiet_NaN();
    return sum_ + damped_ + alone_ + drifted_ + (frames == 0 ? 0 : left_ * static_cast<double>(frames));
}

std::string ErrorMeter::how() const {
    if (samples_ == 0) return "no frame was redone yet";
    const std::string counts = std::to_string(samples_ + alone_samples_) + " of " +
                               std::to_string(frames_ + frames_since_) + " frames redone";
    std::string text =
        judge_.empty()
            ? "step doubling: largest change of a position when a frame is redone in steps half as long, " +
                  counts + ", what is left a frame later of errors of single frames added up"
            : "another method: largest change of a position, and of a velocity as a frame's way, when a "
              "frame is redone by " +
                  std::string(judge_) + ", " + counts + ", errors of single frames added up";
    if (unknown_ > 0)
        text += "; " + std::to_string(unknown_) + " of them could not be redone: the error is not known";
    return text;
}

}  // namespace orbweaver::mass_spring
