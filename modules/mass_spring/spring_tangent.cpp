#include "spring_tangent.hpp"

namespace orbweaver::mass_spring {

SpringTangent::SpringTangent(const SpringSystem& system, std::span<const Vec3> x)
    : network_(&system.network()), drag_(system.drag()) {
    links_.reserve(network_->springs.size());
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        SpringLink link{s.a, s.b, {}};
        const Vec3 l = x[s.a] - x[s.b];
        if (const double length = norm(l); length > 0) {
            const Tension here = system.tension(i, length);
            link.n = l / length;
            link.across = here.force / length;
            link.along = here.slope - link.across;
            link.damping = s.damping;
        }
        links_.push_back(link);
    }
}

void SpringTangent::apply(double wk, double wc, std::span<const Vec3> u, std::span<Vec3> out) const noexcept {
    const auto is_fixed = [&](std::size_t i) { return network_->fixed[i] != 0; };
    for (std::size_t i = 0; i < u.size(); ++i) out[i] = wc * drag_ * u[i];
    for (const SpringLink& link : links_) {
        const Vec3 du = (is_fixed(link.a) ? Vec3{} : u[link.a]) - (is_fixed(link.b) ? Vec3{} : u[link.b]);
        const double along = (wk * link.along + wc * link.damping) * dot(link.n, du);
        const Vec3 pull = along * link.n + wk * link.across * du;
        out[link.a] += pull;
        out[link.b] -= pull;
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        if (is_fixed(i)) out[i] = {};
}

}  // namespace orbweaver::mass_spring
