#pragma once

#include <cstddef>
#include <span>

namespace orbweaver::mass_spring {

/// How what is off in a run lives on, told by how far two runs part that begin next to each other.
class ErrorGrowth {
public:
    /// Two runs are `parted`[j] times as far apart after j + 1 frames. What is off lasts at least as long as
    /// the least damped motion, of which a frame leaves `left`: twins that differ in fast vibrations come
    /// together sooner than those of slow ones. Beyond what was seen they part as they did over the last half
    /// of it.
    ErrorGrowth(std::span<const double> parted, double left);

    /// How many times the error of a run of `frames` is that of `tried` of its frames, both begun without any.
    double from(double tried, double frames) const;
    /// The same, had nothing parted.
    double damped_from(double tried, double frames) const;
    /// Whether the least difference has become so much larger by then that no method can be exact enough.
    bool is_chaotic(double frames) const;

private:
    double lasting(double frames) const;  ///< sum over frames of what is left of an error of 1
    double damped(double frames) const;

    std::span<const double> parted_;
    double left_;
    double faster_ = 1;  ///< times as far apart over half of what was seen; 1: they stay together
};

}  // namespace orbweaver::mass_spring
