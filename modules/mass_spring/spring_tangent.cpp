#include "spring_system.hpp"

namespace orbweaver::mass_spring {
namespace {

bool is_fixed(const Network& network, std::uint32_t particle) noexcept { return network.fixed[particle] != 0; }

/// u_a - u_b, with fixed ends held.
Vec3 difference(const Network& network, const Spring& s, std::span<const Vec3> u) noexcept {
    return (is_fixed(network, s.a) ? Vec3{} : u[s.a]) - (is_fixed(network, s.b) ? Vec3{} : u[s.b]);
}

void add_pair(const Network& network, const Spring& s, const Vec3& f, std::span<Vec3> out) noexcept {
    if (!is_fixed(network, s.a)) out[s.a] += f;
    if (!is_fixed(network, s.b)) out[s.b] -= f;
}

}  // namespace

// With n = l/|l|, one spring contributes to -(df/dx) the block T' n n^T + (T/|l|)(I - n n^T), with the signs
// + + - - of its two ends.
void SpringSystem::apply_stiffness(std::span<const Vec3> x, std::span<const Vec3> u,
                                   std::span<Vec3> out) const noexcept {
    for (Vec3& each : out) each = {};
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Vec3 l = x[s.a] - x[s.b];
        const double squared = dot(l, l);
        if (squared == 0) continue;
        const Vec3 du = difference(*network_, s, u);
        const double length = std::sqrt(squared);
        const Vec3 along = l * (dot(l, du) / squared);
        const Tension here = tension(i, length);
        add_pair(*network_, s, here.slope * along + here.force / length * (du - along), out);
    }
}

}  // namespace orbweaver::mass_spring
