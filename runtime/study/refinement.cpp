#include "study/refinement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::study {

namespace {

/// x(h) = x + c h^p: from x(2h) and x(h), for the order p that was found, when it is near a whole number.
std::optional<Motion> extrapolate(const Motion& coarse, const Motion& fine, double order) {
    constexpr double kClear = 0.2;
    const double whole = std::round(order);
    if (whole < 1 || std::abs(order - whole) > kClear) return std::nullopt;
    Motion limit = fine;
    const double weight = 1 / (std::exp2(whole) - 1);
    for (std::size_t i = 0; i < limit.positions.size(); ++i)
        limit.positions[i] += weight * (fine.positions[i] - coarse.positions[i]);
    return limit;
}

/// What going on from `before` to `next` changed, and to what that leads.
void compare(const Refined& before, Refined& next, std::size_t rows) {
    next.change_m = distance(before.motion, next.motion, rows);
    if (std::isfinite(before.change_m) && next.change_m > 0)
        next.order = std::log2(before.change_m / next.change_m);
    if (next.rung.step > 0) next.limit = extrapolate(before.motion, next.motion, next.order);
}

}  // namespace

std::vector<Rung> ladder(const Subject& subject, const std::string& method, double coarsest, int count) {
    std::vector<Rung> rungs;
    if (subject.by_tolerance(method)) {
        for (int i = 0; i < count; ++i) {
            const double tolerance = 1 / std::pow(10, i + 3);  // m, nearest to the decimal
            if (tolerance >= subject.least_tolerance() * (1 - 1e-9)) rungs.push_back({method, 0, tolerance});
        }
        return rungs;
    }
    const double first = subject.rung_within(method, coarsest).step;
    for (int i = 0; i < count; ++i) rungs.push_back({method, std::ldexp(first, -i), 0});
    return rungs;
}

std::optional<Refined> refine(const StudySettings& settings, const Subject& subject,
                              const std::vector<Rung>& rungs, double duration, std::size_t rows,
                              const Deadline& deadline) {
    constexpr double kShrinks = 0.75;
    constexpr int kMostIdle = 2;  // rungs in a row that do not: rounding. One may be where no step is ruled yet
    std::optional<Refined> best, before;
    double elapsed = 0;
    int idle = 0;
    for (const Rung& rung : rungs) {
        if (best && 2 * elapsed > deadline.left()) break;
        Trial trial = run_trial(settings, subject, {subject.overrides(rung), duration}, deadline);
        if (trial.ending == Ending::timeout) break;
        if (trial.ending != Ending::done) continue;
        elapsed = trial.elapsed_s;
        Refined next{rung, std::move(trial.motion), std::numeric_limits<double>::infinity(), 0, std::nullopt};
        if (before) compare(*before, next, rows);
        const bool shrinks = !before || next.change_m < kShrinks * before->change_m;
        idle = shrinks ? 0 : idle + 1;
        if (shrinks) best = next;
        if (idle == kMostIdle) break;
        before = std::move(next);
    }
    return best;
}

}  // namespace orbweaver::study
