#include "watch.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace orbweaver::mass_spring {
namespace {

struct Term {
    const char* name;
    Vec3 force;
};

std::array<Term, 4> terms_on(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v,
                             std::size_t particle) {
    Vec3 elastic;
    Vec3 damping;
    const auto& springs = system.network().springs;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& s = springs[i];
        if (s.a != particle && s.b != particle) continue;
        const double sign = s.a == particle ? -1 : 1;
        const Vec3 l = x[s.a] - x[s.b];
        const double length = norm(l);
        elastic += sign * l * pull_factor(l, length, {}, system.tension(i, length).force, 0);
        damping += sign * l * pull_factor(l, length, v[s.a] - v[s.b], 0, s.damping);
    }
    return {{{"external force", system.external_force(particle)},
             {"spring force", elastic},
             {"spring damping", damping},
             {"drag", -system.drag() * v[particle]}}};
}

}  // namespace

Watch::Watch(std::span<const Vec3> x) {
    constexpr double kExtents = 1e6;
    if (x.empty()) return;
    Vec3 low = x[0];
    Vec3 high = x[0];
    for (const Vec3& each : x) {
        low = {std::min(low.x, each.x), std::min(low.y, each.y), std::min(low.z, each.z)};
        high = {std::max(high.x, each.x), std::max(high.y, each.y), std::max(high.z, each.z)};
    }
    middle_ = 0.5 * (low + high);
    reach_ = kExtents * std::max(1.0, distance(low, high));
}

bool Watch::within_reach(const Vec3& position) const noexcept { return distance(position, middle_) <= reach_; }

std::size_t Watch::first_bad(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept {
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!within_reach(x[i]) || !is_finite(v[i])) return i;  // a NaN is within reach of nothing
    }
    return x.size();
}

bool advance_watched(Integrator& integrator, const Watch& watch, std::span<Vec3> x, std::span<Vec3> v, double h,
                     std::int64_t count, StepBudget& budget) {
    constexpr std::int64_t kStepsPerLook = 256;  // so that a long frame does not go on for nothing
    for (std::int64_t done = 0; done < count; done += kStepsPerLook) {
        if (!integrator.advance(x, v, h, std::min(kStepsPerLook, count - done), budget)) return false;
        if (watch.first_bad(x, v) < x.size()) return false;
    }
    return true;
}

Culprit find_culprit(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v,
                     std::size_t first_bad) {
    std::vector<Vec3> f(x.size());
    system.forces(x, v, f);
    const auto found = std::find_if(f.begin(), f.end(), [](const Vec3& each) { return !is_finite(each); });
    const std::size_t particle = found == f.end() ? first_bad : static_cast<std::size_t>(found - f.begin());

    const auto terms = terms_on(system, x, v, particle);
    const auto bad =
        std::find_if(terms.begin(), terms.end(), [](const Term& t) { return !is_finite(t.force); });
    if (bad != terms.end()) return {particle, bad->name};
    const auto smaller = [](const Term& p, const Term& q) { return norm(p.force) < norm(q.force); };
    return {particle, std::max_element(terms.begin(), terms.end(), smaller)->name};
}

}  // namespace orbweaver::mass_spring
