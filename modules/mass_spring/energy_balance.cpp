#include "energy_balance.hpp"

#include <cmath>
#include <limits>

namespace orbweaver::mass_spring {

EnergyBalance balance_energy(const SpringSystem& system, const Energy& before, std::span<const Vec3> x0,
                             std::span<const Vec3> x1, std::span<const Vec3> v1) noexcept {
    constexpr double kRounding = 1e-9;
    const Energy after = system.energy(x1, v1);
    const StepHooks* hooks = system.hooks();
    double work = hooks != nullptr ? hooks->work() : 0;
    for (std::size_t i = 0; hooks == nullptr && i < x0.size(); ++i)
        work += dot(system.external_force(i), x1[i] - x0[i]);

    EnergyBalance balance;
    balance.gain = after.total() - before.total() - work;
    balance.turnover = before.kinetic + after.kinetic + (hooks != nullptr ? hooks->turnover() : std::abs(work));
    balance.rounding =
        kRounding * (before.elastic + after.elastic + std::abs(before.potential) + std::abs(after.potential));
    if (!std::isfinite(balance.gain)) balance.gain = std::numeric_limits<double>::infinity();
    if (!std::isfinite(balance.turnover)) balance.turnover = 0;
    return balance;
}

double dissipated_power(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v) noexcept {
    double power = 0;
    for (const Vec3& each : v) power += system.drag() * dot(each, each);
    for (const Spring& s : system.network().springs) {
        const Vec3 l = x[s.a] - x[s.b];
        const double square = dot(l, l);
        const double rate = dot(v[s.a] - v[s.b], l);  // times the length
        if (square > 0) power += s.damping * rate * rate / square;
    }
    return power;
}

}  // namespace orbweaver::mass_spring
