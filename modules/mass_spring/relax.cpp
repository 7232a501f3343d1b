#include "relax.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "larger.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The state of a relaxation in fictitious time, whose step is 1.
class Relaxer {
public:
    Relaxer(const SpringSystem& system, std::span<Vec3> x)
        : system_(&system), x_(x), v_(x.size()), f_(x.size()), rest_(x.size()), inverse_mass_(x.size()) {
        restart();
    }

    /// N, largest net force on a free particle.
    double residual() const noexcept {
        double largest = 0;
        for (std::size_t i = 0; i < f_.size(); ++i) {
            if (system_->network().fixed[i] == 0) largest = larger(largest, dot(f_[i], f_[i]));
        }
        return std::sqrt(largest);
    }

    void step() {
        double energy = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (inverse_mass_[i] == 0) continue;
            v_[i] += impulse_ * inverse_mass_[i] * f_[i];
            energy += dot(v_[i], v_[i]) / inverse_mass_[i];
        }
        if (energy < energy_) {
            // The peak lay about half a step back, so go there, with the velocity of then.
            for (std::size_t i = 0; i < x_.size(); ++i) x_[i] -= 0.5 * (v_[i] - inverse_mass_[i] * f_[i]);
            restart();
            return;
        }
        impulse_ = 1;
        energy_ = energy;
        for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += v_[i];
        system_->forces(x_, rest_, f_);
    }

private:
    /// Stands still, with masses for the stiffness that is now. A fictitious mass above S/2, S the sum of
    /// the stiffness of a particle's springs, keeps a step of 1 stable (Barnes 1999); across the spring
    /// the stiffness is |T|/|l|, which exceeds k only in strong compression or on a curve.
    void restart() {
        constexpr double kMargin = 0.55;
        const Network& network = system_->network();
        std::vector<double> stiffness(x_.size());
        for (std::size_t i = 0; i < network.springs.size(); ++i) {
            const Spring& s = network.springs[i];
            const double length = distance(x_[s.a], x_[s.b]);
            const Tension tension = system_->tension(i, length);
            const double across = length > 0 ? std::abs(tension.force) / length : 0;
            const double along = std::max(s.stiffness, tension.slope);
            const double k = std::clamp(across, along, 1e3 * along);
            stiffness[s.a] += k;
            stiffness[s.b] += k;
        }
        for (std::size_t i = 0; i < x_.size(); ++i) {
            v_[i] = {};
            inverse_mass_[i] = network.fixed[i] == 0 && stiffness[i] > 0 ? 1 / (kMargin * stiffness[i]) : 0;
        }
        energy_ = 0;
        impulse_ = 0.5;
        system_->forces(x_, rest_, f_);
    }

    const SpringSystem* system_;
    std::span<Vec3> x_;
    std::vector<Vec3> v_, f_;
    std::vector<Vec3> rest_;  ///< zero velocities, for forces()
    std::vector<double> inverse_mass_;
    double energy_ = 0;     ///< of motion, doubled, at the last half step
    double impulse_ = 0.5;  ///< velocities live at half steps: the first has seen half a step of force
};

}  // namespace

Relaxation relax(SpringSystem& system, std::span<Vec3> x, double tolerance, std::size_t max_iterations) {
    Relaxer relaxer(system, x);
    Relaxation result;
    result.residual = relaxer.residual();
    while (result.residual > tolerance && result.iterations < max_iterations) {
        relaxer.step();
        ++result.iterations;
        result.residual = relaxer.residual();
    }
    result.converged = result.residual <= tolerance;
    return result;
}

}  // namespace orbweaver::mass_spring
