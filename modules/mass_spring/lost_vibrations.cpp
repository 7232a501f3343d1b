#include "lost_vibrations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "spring_tangent.hpp"

namespace orbweaver::mass_spring {
namespace {

/// m^2, of the amplitude: E = m omega^2 A^2/2.
double square_of(const Loss& loss) noexcept {
    if (!(loss.energy > 0)) return 0;
    const double square = 2 * loss.energy / (loss.mass * loss.omega * loss.omega);
    return std::isnan(square) ? std::numeric_limits<double>::infinity() : square;
}

}  // namespace

bool LostVibrations::samples(std::uint64_t frame) noexcept {
    constexpr std::uint64_t kInterval = 64;
    return frame % kInterval <= 1;
}

void LostVibrations::add(const Loss& whole, const Loss& halved) noexcept {
    constexpr double kLostAlike = 2.0 / 3;  // order one halves what it loses, higher orders more than that
    const bool lost = halved.energy > 0 && halved.energy > kLostAlike * whole.energy;
    last_ = lost ? halved : Loss{};
    energy_ += last_.energy * static_cast<double>(frames_since_);
    squares_ += square_of(last_) * static_cast<double>(frames_since_);
    frames_since_ = 0;
}

void LostVibrations::count_frame(double turnover, double motion) noexcept {
    ++frames_since_;
    turnover_ = std::max(turnover_, turnover);
    motion_ = std::max(motion_, motion);
}

double LostVibrations::amplitude() const noexcept {
    return std::sqrt(squares_ + square_of(last_) * static_cast<double>(frames_since_));
}

double LostVibrations::felt() const noexcept {
    const double lost = energy();
    return lost > 0 ? motion_ * std::min(1.0, std::isinf(lost) ? 1.0 : lost / turnover_) : 0;
}

Phase phase_of(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v) {
    const Network& network = system.network();
    Phase phase{{v.begin(), v.end()}, std::vector<Vec3>(x.size()), 0};
    std::vector<Vec3> pull(x.size());
    SpringTangent(system, x).apply(1, 0, v, pull);
    const std::vector<Vec3> rest(x.size());
    system.forces(x, rest, phase.a);
    double twice = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        phase.a[i] = network.fixed[i] != 0 ? Vec3{} : (1 / network.mass[i]) * phase.a[i];
        twice += dot(v[i], pull[i]) + network.mass[i] * dot(phase.a[i], phase.a[i]);
    }
    phase.sharp_energy = twice / 2;
    return phase;
}

Loss loss_between(const Network& network, const Phase& before, const Phase& after, double energy,
                  double slowest, double fastest) {
    const double square =
        std::clamp((before.sharp_energy - after.sharp_energy) / energy, slowest * slowest, fastest * fastest);
    double weighted = 0, most = 0;  // squares of speeds at the vibration's fastest
    for (std::size_t i = 0; i < network.size(); ++i) {
        const Vec3 a = before.a[i] - after.a[i], v = before.v[i] - after.v[i];
        const double speed = network.fixed[i] != 0 ? 0 : dot(a, a) / square + dot(v, v);
        weighted += network.mass[i] * speed;
        most = std::max(most, speed);
    }
    return {energy, std::sqrt(square), most > 0 ? weighted / most : 0};
}

}  // namespace orbweaver::mass_spring
