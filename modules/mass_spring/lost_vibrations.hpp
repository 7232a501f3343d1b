#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// What a stretch of motion lost to neither drag nor damping.
struct Loss {
    double energy = 0;  ///< J
    double omega = 0;   ///< rad/s, of the vibrations that had it
    double mass = 0;    ///< kg, of the same as one particle that moves as far as the farthest
};

/// Vibrations that a method damps away though nothing in the system does. Where steps are too long for them,
/// half the step loses them as well, and step doubling sees nothing; but their energy is gone. Some frames are
/// redone to keep its books, and a sample stands for the frames since the one before.
class LostVibrations {
public:
    /// Steps times angular frequency below which every method follows a vibration well enough for step
    /// doubling.
    static constexpr double kFollowed = 0.2;

    static bool samples(std::uint64_t frame) noexcept;
    /// Of a frame, and of the same in steps of half the length: of vibrations that are followed the latter
    /// loses a half of the former or less, and they do not count. Nor do those within rounding.
    void add(const Loss& whole, const Loss& halved) noexcept;
    /// A frame that moved energy of `turnover` J (see EnergyBalance), and ended with a particle as far as
    /// `motion` m from where the run began.
    void count_frame(double turnover, double motion) noexcept;

    /// J, lost
    double energy() const noexcept { return energy_ + last_.energy * static_cast<double>(frames_since_); }
    /// m, of vibrations that had all of that energy.
    double amplitude() const noexcept;
    /// m, that slower motion may be off by, which felt those vibrations: as much of it as their energy is of
    /// what moves, and no more than all of it.
    double felt() const noexcept;

private:
    Loss last_;            ///< of the last sample
    double energy_ = 0;    ///< J, over the frames that samples stand for
    double squares_ = 0;   ///< J s^2, their energy over the square of their frequency
    double turnover_ = 0;  ///< J, the most of a frame
    double motion_ = 0;    ///< m, the most
    std::uint64_t frames_since_ = 0;
};

/// Where a system stands in its vibrations.
struct Phase {
    std::vector<Vec3> v;      ///< m/s
    std::vector<Vec3> a;      ///< m/s^2, what springs and loads alone would give; zero for fixed particles
    double sharp_energy = 0;  ///< J/s^2, energy times the square of the frequency: (v.K v + a.M a)/2
};

Phase phase_of(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v);

/// Of vibrations of which something is left at `before` and less at `after`, which then lost `energy` J in all:
/// how fast they are, by the loss of sharp energy (taken between `slowest` and `fastest`, rad/s), and how
/// heavy, by who moves.
Loss loss_between(const Network& network, const Phase& before, const Phase& after, double energy,
                  double slowest, double fastest);

}  // namespace orbweaver::mass_spring
