#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "orbweaver/vec3.hpp"

namespace orbweaver::mass_spring {

/// Adds up the position error of a run from frames redone in steps half as long, or by another method. Early
/// frames are sampled more densely (0, 1, 2, 4 ... 64, 128, 192 ...), and a sample stands for the frames since
/// the one before. Of each frame's error counts what is left of it a frame later, where that is known, for what
/// is damped out by then does not add up; and once, the most that was damped out.
class ErrorMeter {
public:
    /// `judge`: the other method by which frames are redone; empty: in steps half as long.
    explicit ErrorMeter(std::string_view judge = {}) noexcept : judge_(judge) {}

    /// Whether a frame of that index is to be redone: always where none was yet, as after a restart.
    bool wants(std::uint64_t frame) const noexcept;
    /// Positions at the frame's end, m, with steps of h and of h/2. By Richardson, the error of the former is
    /// their difference times 2^p/(2^p - 1), p the order of convergence.
    void add(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept;
    /// Positions, m, and velocities, m/s, at the frame's end, and those that the judge has. What a velocity is
    /// off by counts as the way of a frame of `frame_step` s.
    void add_judged(std::span<const Vec3> x, std::span<const Vec3> judged_x, std::span<const Vec3> v,
                    std::span<const Vec3> judged_v, double frame_step) noexcept;
    /// The frame after the last one that was added went on from both ends of it: what their difference came to.
    void follow(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept;
    /// Of a frame that was redone because it stands out: it stands for itself alone, and those before it for
    /// what they did.
    void add_alone(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept;
    /// The frame after that one went on from both ends of it: what the difference grew by, it goes on to grow
    /// by.
    void follow_alone(std::span<const Vec3> whole, std::span<const Vec3> halved, int order) noexcept;
    /// The frame could not be redone: the error is not known, and counts as infinite.
    void add_unknown() noexcept;
    void count_frame() noexcept {
        ++frames_since_;
        drifted_ += drift_;
    }

    double estimate() const noexcept;  ///< m; NaN where no frame was redone
    std::string how() const;

private:
    void add_sample(double error) noexcept;

    std::string_view judge_;
    double sum_ = 0;      ///< m, what is left of errors of the frames that samples but the last stand for
    double last_ = 0;     ///< m, of the last sample
    double left_ = 0;     ///< m, of that, a frame later
    double damped_ = 0;   ///< m, the most that a sample lost within that frame
    double alone_ = 0;    ///< m, errors of frames that stand out
    double latest_ = 0;   ///< m, of the last of them
    double drift_ = 0;    ///< m a frame, by which what they left grows
    double drifted_ = 0;  ///< m, by which it grew so far
    std::uint64_t samples_ = 0;
    std::uint64_t alone_samples_ = 0;
    std::uint64_t unknown_ = 0;       ///< of the samples
    std::uint64_t frames_ = 0;        ///< that samples stand for
    std::uint64_t last_frames_ = 0;   ///< of them, the last
    std::uint64_t frames_since_ = 0;  ///< the last sample
};

}  // namespace orbweaver::mass_spring
