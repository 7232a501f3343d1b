#pragma once

#include <cstdint>

namespace orbweaver::mass_spring {

/// Vibrations that a method damps away though nothing in the system does. Where steps are too long for them,
/// half the step loses them as well, and step doubling sees nothing; but their energy is gone. Some frames are
/// redone to keep its books, and a sample stands for the frames since the one before.
class LostVibrations {
public:
    /// Steps times angular frequency below which every method follows a vibration well enough for step
    /// doubling.
    static constexpr double kFollowed = 0.2;

    static bool samples(std::uint64_t frame) noexcept;
    /// J that a frame lost to neither drag nor damping in its steps, and in steps of half the length: of
    /// vibrations that are followed the latter is a half of the former or less, and they do not count. Nor does
    /// less than `rounding` J.
    void add(double whole, double halved, double rounding) noexcept;
    void count_frame() noexcept { ++frames_since_; }

    double energy() const noexcept {
        return energy_ + last_ * static_cast<double>(frames_since_);
    }  ///< J, lost
    /// m, of one particle of `mass` kg that vibrated at `omega` rad/s with all of that energy: the lightest and
    /// the fastest there are give the scale of what positions may be off by.
    double amplitude(double mass, double omega) const noexcept;

private:
    double energy_ = 0;  ///< J, over the frames that samples stand for
    double last_ = 0;    ///< J, of the last sample
    std::uint64_t frames_since_ = 0;
};

}  // namespace orbweaver::mass_spring
