#include <algorithm>
#include <array>
#include <cmath>

#include "builtin_methods.hpp"
#include "larger.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kDamping = 2.0 / 13;  ///< of the polynomial inside its interval
constexpr std::size_t kMostStages = 250;

/// Of stage j: Y_j = rest Y_0 + mu Y_j-1 + nu Y_j-2 + h (mu_slope F_j-1 + gamma F_0).
struct StageWeights {
    double rest = 0, mu = 0, nu = 0, mu_slope = 0, gamma = 0;
};

/// Chebyshev's polynomial and its derivatives at w0, T_j, T_j', T_j''.
using Chebyshev = std::array<double, 3>;

std::vector<Chebyshev> chebyshev(double w, std::size_t degree) {
    std::vector<Chebyshev> t{{1, 0, 0}, {w, 1, 0}};
    while (t.size() <= degree) {
        const Chebyshev &p = t[t.size() - 1], &q = t[t.size() - 2];
        t.push_back({2 * w * p[0] - q[0], 2 * p[0] + 2 * w * p[1] - q[1], 4 * p[1] + 2 * w * p[2] - q[2]});
    }
    return t;
}

double center(std::size_t stages) noexcept { return 1 + kDamping / static_cast<double>(stages * stages); }

/// Sommeijer, Shampine and Verwer's (2.1) to (2.5).
std::vector<StageWeights> weights(std::size_t stages) {
    const double w0 = center(stages);
    const std::vector<Chebyshev> t = chebyshev(w0, stages);
    const double w1 = t[stages][1] / t[stages][2];
    const auto b = [&](std::size_t j) {
        const Chebyshev& p = t[std::max<std::size_t>(j, 2)];
        return p[2] / (p[1] * p[1]);
    };
    std::vector<StageWeights> all(stages + 1);
    all[1] = {1, 0, 0, 0, b(1) * w1};
    for (std::size_t j = 2; j <= stages; ++j) {
        StageWeights& w = all[j];
        w.mu = 2 * b(j) * w0 / b(j - 1);
        w.nu = -b(j) / b(j - 2);
        w.rest = 1 - w.mu - w.nu;
        w.mu_slope = 2 * b(j) * w1 / b(j - 1);
        w.gamma = -(1 - b(j - 1) * t[j - 1][0]) * w.mu_slope;
    }
    return all;
}

/// The length of the negative real axis that so many stages are stable on, over h.
double reach(std::size_t stages) noexcept {
    const auto squared = static_cast<double>(stages * stages);
    return 2.0 / 3 * (squared - 1) * (1 - 2.0 / 15 * kDamping);
}

std::size_t stages_for(double reached) noexcept {
    return std::max<std::size_t>(2, 1 + static_cast<std::size_t>(std::sqrt(1 + 1.54 * reached)));
}

/// The stabilised explicit method RKC of order two (Sommeijer, Shampine and Verwer, RKC: an explicit solver for
/// parabolic PDEs, 1998): as many stages as reach over the spectral radius, whose polynomial is Chebyshev's, so
/// that the step grows with the square of the work. For systems that damping makes stiff; along the imaginary
/// axis it reaches no further than others.
class Rkc2 final : public Method {
public:
    explicit Rkc2(std::size_t length)
        : first_(length),
          a_(length),
          start_x_(length),
          start_v_(length),
          x1_(length),
          v1_(length),
          x2_(length),
          v2_(length) {}

    void begin() noexcept override { has_slope_ = false; }

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        const double radius = system.spectral_radius();
        const double pieces = std::max(1.0, std::ceil(h * radius / reach(kMostStages)));
        const double piece = h / pieces;
        choose(stages_for(piece * radius));
        for (double done = 0; done < pieces; ++done) step_piece(system, x, v, piece);
    }

    /// 4/5 (y_n - y_n+1) + 2/5 h (F_n + F_n+1), of the last piece.
    double error(DynamicSystem&) override {
        double largest = 0;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            const double ex = 0.8 * (start_x_[i] - x1_[i]) + 0.4 * h_ * (start_v_[i] + v1_[i]);
            const double ev = 0.8 * (start_v_[i] - v1_[i]) + 0.4 * h_ * (a_[i] + first_[i]);
            largest = larger(larger(largest, ex), h_ * ev);
        }
        return largest;
    }

    std::size_t memory_bytes() const noexcept override {
        return 8 * a_.capacity() * sizeof(double) + weights_.capacity() * sizeof(StageWeights);
    }

private:
    void choose(std::size_t stages) {
        if (weights_.size() != stages + 1) weights_ = weights(stages);
    }

    void step_piece(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) {
        if (has_slope_)
            a_.swap(first_);
        else
            system.accelerations(x, v, first_);
        begin_stages(x, v, h);
        for (std::size_t j = 2; j < weights_.size(); ++j) {
            system.accelerations(x1_, v1_, a_);
            next_stage(x, v, weights_[j], h);
        }
        std::copy(x.begin(), x.end(), start_x_.begin());
        std::copy(v.begin(), v.end(), start_v_.begin());
        std::copy(x1_.begin(), x1_.end(), x.begin());
        std::copy(v1_.begin(), v1_.end(), v.begin());
        system.accelerations(x, v, a_);
        has_slope_ = true;
        h_ = h;
    }

    /// Y_1, and Y_0 before it.
    void begin_stages(std::span<const double> x, std::span<const double> v, double h) noexcept {
        wide_loop(x.size(),
                  [hm = h * weights_[1].gamma, x = x.data(), v = v.data(), a = first_.data(), x1 = x1_.data(),
                   v1 = v1_.data(), x2 = x2_.data(), v2 = v2_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
                      x2[i] = x[i];
                      v2[i] = v[i];
                      x1[i] = x[i] + hm * v[i];
                      v1[i] = v[i] + hm * a[i];
                  });
    }

    void next_stage(std::span<const double> x, std::span<const double> v, const StageWeights& w,
                    double h) noexcept {
        wide_loop(x.size(), [w, h, x = x.data(), v = v.data(), first = first_.data(), a = a_.data(),
                             x1 = x1_.data(), v1 = v1_.data(), x2 = x2_.data(),
                             v2 = v2_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            x2[i] = w.rest * x[i] + w.mu * x1[i] + w.nu * x2[i] + h * (w.mu_slope * v1[i] + w.gamma * v[i]);
            v2[i] = w.rest * v[i] + w.mu * v1[i] + w.nu * v2[i] + h * (w.mu_slope * a[i] + w.gamma * first[i]);
        });
        x1_.swap(x2_);
        v1_.swap(v2_);
    }

    std::vector<double> first_, a_;          ///< F_0's and the last stage's
    std::vector<double> start_x_, start_v_;  ///< of the last piece
    std::vector<double> x1_, v1_, x2_, v2_;  ///< of stages j-1 and j-2
    std::vector<StageWeights> weights_;      ///< of the stages in use
    double h_ = 0;                           ///< s, of the last piece
    bool has_slope_ = false;                 ///< a_ is that of the state the last piece ended in
};

}  // namespace

std::unique_ptr<Method> make_rkc2(std::size_t length) { return std::make_unique<Rkc2>(length); }

}  // namespace orbweaver::mass_spring
