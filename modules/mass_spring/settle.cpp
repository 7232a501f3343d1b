#include "settle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "larger.hpp"
#include "linear_solver.hpp"
#include "relax.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr std::size_t kMostIterations = 500;
constexpr std::size_t kMostRelaxations = 10;
constexpr std::size_t kRelaxationSteps = 2000;

/// One way from x towards rest, and how far along it one may go.
class Descent {
public:
    Descent(const SpringSystem& system, std::span<Vec3> x)
        : system_(&system),
          x_(x),
          still_(x.size()),
          force_(x.size()),
          step_(x.size()),
          trial_(x.size()),
          diagonal_(x.size()),
          blocks_(system.network().springs.size()),
          solver_(make_linear_solver(system.linear_solver(), system.network())) {
        for (const Spring& s : system.network().springs) stiffest_ = std::max(stiffest_, s.stiffness);
        look();
    }

    double residual() const noexcept { return residual_; }

    /// False when no step led down.
    bool iterate() {
        constexpr double kFirst = 1e-9, kLargest = 1e6;  // of the stiffest spring
        while (stiffest_ > 0 && shift_ <= kLargest * stiffest_) {
            if (find_step() && search_line()) {
                shift_ = shift_ > kFirst * stiffest_ ? shift_ / 10 : 0;
                return true;
            }
            shift_ = std::max(10 * shift_, kFirst * stiffest_);
        }
        shift_ = 0;
        return false;
    }

    /// After x was moved by somebody else.
    void look() {
        energy_ = energy(x_);
        residual_ = residual(x_);
    }

private:
    /// Of the whole: springs, gravity and external forces.
    double energy(std::span<const Vec3> x) const noexcept {
        double sum = system_->energy(x, still_).total();
        for (std::size_t i = 0; i < x.size(); ++i) sum -= dot(system_->external_force(i), x[i]);
        return sum;
    }

    /// Leaves the forces in force_.
    double residual(std::span<const Vec3> x) noexcept {
        system_->forces(x, still_, force_);
        double largest = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (system_->network().fixed[i] != 0) force_[i] = {};
            largest = larger(largest, dot(force_[i], force_[i]));
        }
        return std::sqrt(largest);
    }

    bool find_step() {
        const auto& springs = system_->network().springs;
        for (std::size_t i = 0; i < springs.size(); ++i) {
            const Vec3 l = x_[springs[i].a] - x_[springs[i].b];
            blocks_[i] = stiffness_block(l, system_->tension(i, norm(l)), shift_ > 0);
        }
        std::fill(diagonal_.begin(), diagonal_.end(), shift_);
        if (!solver_->factorize(diagonal_, blocks_)) return false;
        system_->forces(x_, still_, force_);
        solver_->solve(force_, step_);
        // An iterative solver finds only here that a matrix is not positive definite.
        return std::all_of(step_.begin(), step_.end(), [](const Vec3& each) { return is_finite(each); });
    }

    bool search_line() {
        constexpr int kMostHalvings = 12;
        constexpr double kEnough = 1e-4;  // of the descent that the slope promises (Armijo)
        double slope = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) slope += dot(force_[i], step_[i]);
        double length = 1;
        for (int halving = 0; halving < kMostHalvings; ++halving, length /= 2) {
            for (std::size_t i = 0; i < x_.size(); ++i) trial_[i] = x_[i] + length * step_[i];
            const double energy_there = energy(trial_);
            const double residual_there = residual(trial_);
            // Near rest changes of the energy are below its rounding, and the residual alone tells.
            const bool tells = length * slope > 1e-14 * std::abs(energy_);
            const bool down = tells && energy_there <= energy_ - kEnough * length * slope;
            const bool halved = residual_there < 0.5 * residual_ && (shift_ == 0 || !tells);
            if (!down && !halved) continue;
            std::copy(trial_.begin(), trial_.end(), x_.begin());
            energy_ = energy_there;
            residual_ = residual_there;
            return true;
        }
        return false;
    }

    const SpringSystem* system_;
    std::span<Vec3> x_;
    std::vector<Vec3> still_;  ///< zero velocities
    std::vector<Vec3> force_, step_, trial_;
    std::vector<double> diagonal_;
    std::vector<SymmetricBlock> blocks_;
    std::unique_ptr<LinearSolver> solver_;
    double stiffest_ = 0;  ///< N/m
    double shift_ = 0;     ///< N/m, added to the diagonal
    double energy_ = 0;    ///< J
    double residual_ = 0;  ///< N
};

/// What sums of spring forces can be told from zero.
double rounding(const Network& network, std::span<const Vec3> x) {
    std::vector<double> sums(x.size());
    for (const Spring& s : network.springs) {
        const double force = s.stiffness * (norm(x[s.a]) + norm(x[s.b]) + s.rest_length);
        sums[s.a] += force;
        sums[s.b] += force;
    }
    const double largest = sums.empty() ? 0 : *std::max_element(sums.begin(), sums.end());
    return 4 * std::numeric_limits<double>::epsilon() * largest;
}

}  // namespace

Settlement settle(SpringSystem& system, std::span<Vec3> x, double tolerance) {
    Settlement result;
    result.tolerance = std::max(tolerance, rounding(system.network(), x));
    const std::vector<Vec3> start(x.begin(), x.end());
    Descent descent(system, x);
    const double residual_at_start = descent.residual();
    for (std::size_t stuck = 0; descent.residual() > result.tolerance && result.iterations < kMostIterations;) {
        ++result.iterations;
        if (descent.iterate()) continue;
        if (++stuck > kMostRelaxations) break;
        result.relaxations += relax(system, x, result.tolerance, kRelaxationSteps).iterations;
        descent.look();
    }
    if (descent.residual() > result.tolerance && descent.residual() >= residual_at_start) {
        std::copy(start.begin(), start.end(), x.begin());  // there is no rest that way
        descent.look();
    }
    result.residual = descent.residual();
    result.converged = result.residual <= result.tolerance;
    return result;
}

}  // namespace orbweaver::mass_spring
