#include "rehearsal.hpp"

#include <algorithm>
#include <cmath>

#include "energy_balance.hpp"
#include "integrator.hpp"
#include "larger.hpp"
#include "orbweaver/random.hpp"

namespace orbweaver::mass_spring {
namespace {

double size_of(std::span<const Vec3> forces) noexcept {
    double sum = 0;
    for (const Vec3& f : forces) sum += dot(f, f);
    return std::sqrt(sum);
}

/// How many times as far apart as at first two runs are after each frame; as far as both go and are finite.
std::vector<double> parting(const Performance& one, const Performance& other, std::size_t particles,
                            double apart) {
    std::vector<double> growth;
    const std::size_t end = std::min(one.x.size(), other.x.size());
    for (std::size_t begin = 0; begin < end; begin += particles) {
        double largest = 0;
        for (std::size_t i = begin; i < begin + particles; ++i)
            largest = larger(largest, distance(one.x[i], other.x[i]));
        if (!std::isfinite(largest)) break;
        growth.push_back(largest / apart);
    }
    return growth;
}

}  // namespace

Rehearsal::Rehearsal(SpringSystem& system, RunAhead run)
    : system_(system), run_(std::move(run)), strongest_(strongest_within(run_.frames)) {
    system_.set_surroundings(run_.surroundings);
}

Rehearsal::~Rehearsal() { system_.set_surroundings(run_.surroundings); }

Rehearsal::Strongest Rehearsal::strongest_within(double frames) {
    constexpr double kMostForces = 2e6;  // looked at: a fraction of a second
    Strongest found;
    if (!run_.load) return found;
    const double most = std::max(64.0, kMostForces / static_cast<double>(run_.x.size()));
    const double stride = std::max(1.0, std::floor(frames / most));
    std::vector<Vec3> change;
    for (std::uint64_t i = 0; 1 + static_cast<double>(i) * stride < frames; ++i) {
        const double frame = 1 + static_cast<double>(i) * stride;
        const auto before = run_.load((frame - 1) * run_.frame_step);
        change.assign(before.begin(), before.end());
        const auto forces = run_.load(frame * run_.frame_step);
        for (std::size_t j = 0; j < change.size(); ++j) change[j] = forces[j] - change[j];
        const double strength = size_of(forces) + size_of(change);
        if (strength > found.strength) found = {frame, strength};
    }
    return found;
}

Rehearsal::Stretch Rehearsal::from_start(std::size_t count) const {
    return {0, count, {run_.x.begin(), run_.x.end()}, std::vector<Vec3>(run_.x.size()), {}};
}

void Rehearsal::take_first(std::size_t count) { stretches_ = {from_start(count)}; }

std::vector<double> Rehearsal::take_strongest(std::size_t count, std::size_t horizon, const Pace& scout,
                                              const WorkLimit& limit) {
    constexpr double kApart = 1e-10;  // m: far above rounding, far below what bends the equations
    take_first(count);
    const std::size_t third = std::max<std::size_t>(1, count / 3);
    const Strongest strongest = strongest_within(static_cast<double>(horizon - std::min(horizon, third)));
    Stretch around;
    around.first = static_cast<std::size_t>(strongest.frame) - std::min<std::size_t>(third, strongest.frame);
    around.count = 2 * third;

    Stretch start = from_start(horizon);
    Performance one, other;
    const WorkLimit half{limit.seconds / 2, limit.max_substeps};
    play(start, scout, half, one, &around);
    const RandomStream random(1, "twin");
    for (std::size_t i = 0; i < start.x.size(); ++i) {
        if (system_.network().fixed[i] != 0) continue;
        const auto at = [&](std::size_t axis) { return random.uniform(3 * i + axis, -kApart, kApart); };
        start.x[i] += Vec3{at(0), at(1), at(2)};
    }
    start.count = one.x.size() / start.x.size();
    play(start, scout, half, other);

    if (around.first > third && !around.x.empty()) stretches_ = {from_start(third), std::move(around)};
    if (strongest.strength > 0) strength_ahead_ = std::max(1.0, strongest_.strength / strongest.strength);
    return parting(one, other, start.x.size(), kApart);
}

std::size_t Rehearsal::frames() const noexcept {
    std::size_t sum = 0;
    for (const Stretch& stretch : stretches_) sum += stretch.count;
    return sum;
}

std::size_t Rehearsal::longest_stretch() const noexcept { return stretches_.back().count; }

void Rehearsal::blow(double frame) {
    if (!run_.load) return;
    Surroundings surroundings = run_.surroundings;
    surroundings.external = run_.load(frame * run_.frame_step);
    system_.set_surroundings(surroundings);
}

bool Rehearsal::advance(Integrator& integrator, const Pace& pace, std::int64_t max_substeps,
                        std::vector<Vec3>& x, std::vector<Vec3>& v) {
    const double h = run_.frame_step / static_cast<double>(pace.substeps);
    StepBudget budget(max_substeps);
    if (pace.substeps <= max_substeps / 2) return integrator.advance(x, v, h, pace.substeps, budget);
    const std::vector<Vec3> start = x;
    const Energy before = system_.energy(x, v);
    return integrator.advance(x, v, h, pace.substeps, budget) &&
           balance_energy(system_, before, start, x, v).holds();
}

bool Rehearsal::play(const Stretch& stretch, const Pace& pace, const WorkLimit& limit, Performance& performance,
                     Stretch* into) {
    const double before = system_.work_seconds();
    std::vector<Vec3> x = stretch.x, v = stretch.v;
    system_.put_on_arms(x);
    system_.set_creep(stretch.creep);
    Integrator integrator(system_, *pace.method);
    performance.order = integrator.order();
    for (std::size_t frame = 0; frame < stretch.count; ++frame) {
        if (system_.work_seconds() - before > limit.seconds) return false;
        if (into != nullptr && into->first == frame) {
            into->x = x;
            into->v = v;
            into->creep.resize(system_.creep_count());
            system_.get_creep(into->creep);
        }
        blow(static_cast<double>(stretch.first + frame));
        if (!advance(integrator, pace, limit.max_substeps, x, v)) return false;
        performance.x.insert(performance.x.end(), x.begin(), x.end());
    }
    return true;
}

std::optional<double> Rehearsal::cost_of_a_frame(const Pace& pace, const WorkLimit& limit) {
    Performance one;
    Stretch stretch = from_start(1);
    stretch.first = static_cast<std::size_t>(strongest_.frame);
    const double before = system_.work_seconds();
    if (!play(stretch, pace, limit, one)) return std::nullopt;
    return system_.work_seconds() - before;
}

std::optional<Performance> Rehearsal::perform(const Pace& pace, const WorkLimit& limit) {
    Performance performance;
    const double before = system_.work_seconds();
    for (const Stretch& stretch : stretches_) {
        const WorkLimit left{limit.seconds - (system_.work_seconds() - before), limit.max_substeps};
        if (!play(stretch, pace, left, performance)) return std::nullopt;
    }
    performance.cost = (system_.work_seconds() - before) / static_cast<double>(frames());
    return performance;
}

}  // namespace orbweaver::mass_spring
