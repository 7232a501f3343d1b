#include "adviser.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lanczos.hpp"
#include "orbweaver/random.hpp"
#include "quantity.hpp"
#include "spring_tangent.hpp"
#include "stability_limit.hpp"

namespace orbweaver::mass_spring {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// M^-1/2 (wk K + wc C) M^-1/2, with K and C the tangents at x; zero where particles are fixed.
class ScaledTangent {
public:
    ScaledTangent(const SpringSystem& system, std::span<const Vec3> x)
        : tangent_(system, x), scale_(x.size()), u_(x.size()) {
        const Network& network = system.network();
        for (std::size_t i = 0; i < x.size(); ++i) {
            scale_[i] = network.fixed[i] != 0 ? 0 : 1 / std::sqrt(network.mass[i]);
        }
    }

    void apply(double wk, double wc, std::span<const Vec3> in, std::span<Vec3> out) noexcept {
        for (std::size_t i = 0; i < in.size(); ++i) u_[i] = scale_[i] * in[i];
        tangent_.apply(wk, wc, u_, out);
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = scale_[i] * out[i];
    }

    /// The quotient q.(wk K + wc C) q of a unit vector.
    double quotient(double wk, double wc, std::span<const Vec3> q) {
        std::vector<Vec3> out(q.size());
        apply(wk, wc, q, out);
        double sum = 0;
        for (std::size_t i = 0; i < q.size(); ++i) sum += dot(q[i], out[i]);
        return sum;
    }

    EigenPair top(double wk, double wc) {
        const RandomStream random(0, "adviser");
        std::vector<Vec3> start(scale_.size());
        for (std::size_t i = 0; i < start.size(); ++i) {
            if (scale_[i] == 0) continue;
            start[i] = {random.uniform(3 * i, -1, 1), random.uniform(3 * i + 1, -1, 1),
                        random.uniform(3 * i + 2, -1, 1)};
        }
        return largest_eigenpair([&](std::span<const Vec3> in, std::span<Vec3> out) { apply(wk, wc, in, out); },
                                 start, 1e-4);
    }

    std::span<const SpringLink> links() const noexcept { return tangent_.links(); }

    /// M^-1/2 q: the displacements of a mode.
    std::vector<Vec3> displacements(std::span<const Vec3> q) const {
        std::vector<Vec3> u(q.size());
        for (std::size_t i = 0; i < q.size(); ++i) u[i] = scale_[i] * q[i];
        return u;
    }

private:
    SpringTangent tangent_;
    std::vector<double> scale_;  ///< kg^-1/2, 0 where fixed
    std::vector<Vec3> u_;
};

struct Mode {
    double limit = kInfinite;
    double omega = 0;
    double mu = 0;
    std::vector<Vec3> shape;  ///< mass-scaled, unit length
};

/// `stiffest`: rad/s, of the whole system. Bodies that move as a whole swing by what rounding of their places
/// strains them: far slower than that, unless they are as far off as a billion of their sizes.
Mode mode_of(ScaledTangent& tangent, EigenPair pair, const MethodInfo& method, double radius, double stiffest) {
    constexpr double kRounding = 1e-7;
    if (pair.vector.empty()) return {};
    Mode mode;
    mode.omega = std::sqrt(std::max(0.0, tangent.quotient(1, 0, pair.vector)));
    if (mode.omega < kRounding * stiffest) mode.omega = 0;
    mode.mu = std::max(0.0, tangent.quotient(0, 1, pair.vector));
    mode.limit = stability_limit(method, mode.omega, mode.mu, radius);
    mode.shape = std::move(pair.vector);
    return mode;
}

/// A method that amplifies undamped oscillation is limited where omega^2/mu is largest, in whichever mode:
/// the largest lambda of K q = lambda C q, found from above by Dinkelbach's iteration on K - lambda C.
Mode least_damped(ScaledTangent& tangent, Mode mode, const MethodInfo& method, double radius, double stiffest) {
    constexpr int kMaxRounds = 12;
    for (int round = 0; round < kMaxRounds && mode.limit > 0 && mode.mu > 0; ++round) {
        const double ratio = mode.omega * mode.omega / mode.mu;
        Mode next = mode_of(tangent, tangent.top(1, -ratio), method, radius, stiffest);
        if (!(next.limit < mode.limit * (1 - 1e-6))) break;
        mode = std::move(next);
    }
    return mode;
}

/// The spring with the largest share in a mode's elastic energy, or in its damping when that rules it.
void name_spring(std::span<const SpringLink> links, std::span<const Vec3> u, Advice& advice) {
    const bool by_damping = advice.damping_rate > advice.angular_frequency;
    double largest = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const Vec3 du = u[links[i].a] - u[links[i].b];
        const double along = dot(links[i].n, du);
        const double share = by_damping ? links[i].damping * along * along
                                        : links[i].along * along * along + links[i].across * dot(du, du);
        if (share <= largest) continue;
        largest = share;
        advice.spring = i;
        advice.has_spring = true;
    }
}

std::string sentence_of(const Advice& advice, const MethodInfo& method) {
    const std::string name(method.name);
    if (std::isinf(advice.stable_step)) return "every step of " + name + " is stable here";
    const std::string mode =
        "a mode of " + number_text(advice.angular_frequency) + " rad/s with a damping rate of " +
        number_text(advice.damping_rate) + " /s" +
        (advice.has_spring ? ", strongest in spring " + std::to_string(advice.spring) : "");
    if (advice.stable_step == 0) return "no step of " + name + " is stable: it amplifies " + mode;
    return "the largest stable step of " + name + " is " + seconds_text(advice.stable_step) + ", set by " +
           mode;
}

}  // namespace

Advice advise(const SpringSystem& system, std::span<const Vec3> x, const MethodInfo& method) {
    ScaledTangent tangent(system, x);
    const double radius = system.spectral_bound().radius();
    Mode worst = mode_of(tangent, tangent.top(1, 0), method, radius, 0);
    const double stiffest = worst.omega;
    const bool needs_damping = worst.omega > 0 && stability_limit(method, worst.omega, 0, radius) == 0;
    Mode most_damped = mode_of(tangent, tangent.top(0, 1), method, radius, stiffest);
    if (most_damped.limit < worst.limit) worst = std::move(most_damped);
    if (needs_damping) worst = least_damped(tangent, std::move(worst), method, radius, stiffest);

    Advice advice;
    advice.stable_step = worst.limit;
    advice.angular_frequency = worst.omega;
    advice.damping_rate = worst.mu;
    if (!worst.shape.empty()) name_spring(tangent.links(), tangent.displacements(worst.shape), advice);
    advice.sentence = sentence_of(advice, method);
    return advice;
}

}  // namespace orbweaver::mass_spring
