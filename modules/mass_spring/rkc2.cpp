#include <algorithm>
#include <array>
#include <cmath>

#include "builtin_methods.hpp"
#include "larger.hpp"
#include "wide_loop.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kDamping = 2.0 / 13;  ///< of the polynomial inside its interval

/// Of stage j, D_j = Y_j - Y_0: D_j = mu D_j-1 + nu D_j-2 + h (mu_slope F_j-1 + gamma F_0).
struct StageWeights {
    double mu = 0, nu = 0, mu_slope = 0, gamma = 0;
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

/// Sommeijer, Shampine and Verwer's (2.1) to (2.5), less Y_0: what does not move loses nothing to rounding.
std::vector<StageWeights> weights(std::size_t stages) {
    const double w0 = center(stages);
    const std::vector<Chebyshev> t = chebyshev(w0, stages);
    const double w1 = t[stages][1] / t[stages][2];
    const auto b = [&](std::size_t j) {
        const Chebyshev& p = t[std::max<std::size_t>(j, 2)];
        return p[2] / (p[1] * p[1]);
    };
    std::vector<StageWeights> all(stages + 1);
    all[1].gamma = b(1) * w1;
    for (std::size_t j = 2; j <= stages; ++j) {
        StageWeights& w = all[j];
        w.mu = 2 * b(j) * w0 / b(j - 1);
        w.nu = -b(j) / b(j - 2);
        w.mu_slope = 2 * b(j) * w1 / b(j - 1);
        w.gamma = -(1 - b(j - 1) * t[j - 1][0]) * w.mu_slope;
    }
    return all;
}

/// Stable to -reach on the real axis: 2/3 (s^2 - 1)(1 - 2/15 damping) of s stages is more than this takes.
std::size_t stages_for(double reach) noexcept {
    constexpr double kMost = 250;  // from where rounding inside a step grows
    return std::max<std::size_t>(2, static_cast<std::size_t>(std::min(kMost, 1 + std::sqrt(1 + 1.54 * reach))));
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
          x_(length),
          v_(length),
          dx1_(length),
          dv1_(length),
          dx2_(length),
          dv2_(length) {}

    void begin() noexcept override { has_slope_ = false; }

    void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) override {
        choose(stages_for(h * system.spectral_radius()));
        if (has_slope_)
            a_.swap(first_);
        else
            system.accelerations(x, v, first_);
        begin_stages(x, v, h);
        for (std::size_t j = 2; j < weights_.size(); ++j) {
            system.accelerations(x_, v_, a_);
            next_stage(x, v, weights_[j], h);
        }
        std::copy(x_.begin(), x_.end(), x.begin());
        std::copy(v_.begin(), v_.end(), v.begin());
        system.accelerations(x, v, a_);
        has_slope_ = true;
        h_ = h;
    }

    /// 4/5 (y_n - y_n+1) + 2/5 h (F_n + F_n+1)
    double error(DynamicSystem&) override {
        double largest = 0;
        for (std::size_t i = 0; i < a_.size(); ++i) {
            const double ex = -0.8 * dx1_[i] + 0.4 * h_ * (2 * v_[i] - dv1_[i]);
            const double ev = -0.8 * dv1_[i] + 0.4 * h_ * (a_[i] + first_[i]);
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

    void begin_stages(std::span<const double> x, std::span<const double> v, double h) noexcept {
        wide_loop(x.size(), [hm = h * weights_[1].gamma, x = x.data(), v = v.data(), a = first_.data(),
                             xs = x_.data(), vs = v_.data(), dx1 = dx1_.data(), dv1 = dv1_.data(),
                             dx2 = dx2_.data(), dv2 = dv2_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            dx2[i] = 0;
            dv2[i] = 0;
            dx1[i] = hm * v[i];
            dv1[i] = hm * a[i];
            xs[i] = x[i] + dx1[i];
            vs[i] = v[i] + dv1[i];
        });
    }

    void next_stage(std::span<const double> x, std::span<const double> v, const StageWeights& w,
                    double h) noexcept {
        wide_loop(x.size(), [w, h, x = x.data(), v = v.data(), first = first_.data(), a = a_.data(),
                             xs = x_.data(), vs = v_.data(), dx1 = dx1_.data(), dv1 = dv1_.data(),
                             dx2 = dx2_.data(), dv2 = dv2_.data()](std::size_t i) ORBWEAVER_ALWAYS_INLINE {
            dx2[i] = w.mu * dx1[i] + w.nu * dx2[i] + h * (w.mu_slope * vs[i] + w.gamma * v[i]);
            dv2[i] = w.mu * dv1[i] + w.nu * dv2[i] + h * (w.mu_slope * a[i] + w.gamma * first[i]);
            xs[i] = x[i] + dx2[i];
            vs[i] = v[i] + dv2[i];
        });
        dx1_.swap(dx2_);
        dv1_.swap(dv2_);
    }

    std::vector<double> first_, a_;              ///< F_0's and the last stage's
    std::vector<double> x_, v_;                  ///< of the last stage
    std::vector<double> dx1_, dv1_, dx2_, dv2_;  ///< Y_j - Y_0 of the last two stages
    std::vector<StageWeights> weights_;          ///< of the stages in use
    double h_ = 0;                               ///< s, of the last step
    bool has_slope_ = false;                     ///< a_ is that of the state the last step ended in
};

}  // namespace

std::unique_ptr<Method> make_rkc2(std::size_t length) { return std::make_unique<Rkc2>(length); }

}  // namespace orbweaver::mass_spring
