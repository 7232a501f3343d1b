#include <algorithm>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {
namespace {

/// The ends of a spring in planes of coordinates.
class Ends {
public:
    Ends(const Network& network, const Spring& spring, const Packing& packing) noexcept
        : a_(packing.place(spring.a)),
          b_(packing.place(spring.b)),
          plane_(packing.plane()),
          wa_(weight(network, spring.a)),
          wb_(weight(network, spring.b)) {}

    double weight() const noexcept { return wa_ + wb_; }  ///< 1/kg, 0 when both are fixed
    /// x_a - x_b
    Vec3 extent(std::span<const double> x) const noexcept {
        return {x[a_] - x[b_], x[plane_ + a_] - x[plane_ + b_], x[2 * plane_ + a_] - x[2 * plane_ + b_]};
    }
    /// Each end by what an impulse p (kg m) moves it.
    void push(std::span<double> x, const Vec3& p) const noexcept {
        move(x, a_, wa_ * p);
        move(x, b_, -wb_ * p);
    }

private:
    static double weight(const Network& network, std::size_t i) noexcept {
        return network.fixed[i] != 0 ? 0 : 1 / network.mass[i];
    }
    void move(std::span<double> x, std::size_t i, const Vec3& way) const noexcept {
        x[i] += way.x;
        x[plane_ + i] += way.y;
        x[2 * plane_ + i] += way.z;
    }

    std::size_t a_, b_, plane_;
    double wa_, wb_;
};

}  // namespace

void SpringSystem::free_accelerations(std::span<const double> v, std::span<double> a, double h) const noexcept {
    const std::size_t plane = packing().plane();
    std::fill(a.begin(), a.end(), 0.0);
    for (std::size_t i = 0; i < size(); ++i) {
        if (network_->fixed[i] != 0) continue;
        const double inverse = 1 / network_->mass[i];
        const std::size_t at = packing().place(i);
        const Vec3 velocity{v[at], v[plane + at], v[2 * plane + at]};
        const Vec3 undamped = gravity_ + inverse * (external_force(i) - drag_ * velocity);
        const Vec3 each = undamped / (1 + h * drag_ * inverse);
        a[at] = each.x;
        a[plane + at] = each.y;
        a[2 * plane + at] = each.z;
    }
}

// XPBD's (18) and (26) from lambda = 0, with C = |l| - r, compliance 1/k and damping c: multiplied by k h^2, so
// that a spring without stiffness has a meaning, and with the tangent of a curved one for k.
void SpringSystem::project_springs(std::span<const double> start, std::span<double> x,
                                   double h) const noexcept {
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Ends ends(*network_, s, packing());
        if (ends.weight() == 0) continue;
        const Vec3 l = ends.extent(x);
        const double length = norm(l);
        if (length == 0) continue;
        const Vec3 n = l / length;
        const Tension here = tension(i, length);
        const double damping = s.damping * h;
        const double moved = dot(n, l - ends.extent(start));
        const double pull =
            (here.force * h * h + damping * moved) / ((here.slope * h * h + damping) * ends.weight() + 1);
        ends.push(x, -pull * n);
    }
}

void SpringSystem::limit_strain(std::span<double> x, double strain) const noexcept {
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Ends ends(*network_, s, packing());
        const Vec3 l = ends.extent(x);
        const double length = norm(l);
        if (s.stiffness == 0 || rest_length(i) == 0) continue;  // cut, or never strained
        const double most = (1 + strain) * rest_length(i);
        if (ends.weight() == 0 || length <= most || length == 0) continue;
        ends.push(x, ((most - length) / (length * ends.weight())) * l);
    }
}

}  // namespace orbweaver::mass_spring
