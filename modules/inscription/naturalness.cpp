#include "naturalness.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thread_kinds.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kSlack = 1e-12;  ///< of the largest tension: below minus that a thread pushes

double silk_of(const WebAtRest& web, std::uint32_t thread) {
    const ThreadSegment& each = web.segments[thread];
    return each.width * distance(web.points[each.a], web.points[each.b]);
}

void count_silk(const WebAtRest& plain, const WebChange& change, Naturalness& found) {
    for (const std::uint32_t i : change.removed) found.silk_removed += silk_of(plain, i);
    for (const WebChange::Thickened& part : change.thickened) {
        const double more = (part.width - 1) * (part.to - part.from) * silk_of(plain, part.segment);
        (more > 0 ? found.silk_added : found.silk_removed) += std::abs(more);
    }
    for (const WebChange::Added& thread : change.added)
        found.silk_added += thread.width * plain.segments[thread.like].width *
                            distance(plain.points[thread.a], plain.points[thread.b]);
    double all = 0;
    for (std::uint32_t i = 0; i < plain.segments.size(); ++i) all += silk_of(plain, i);
    found.silk_share = all > 0 ? (found.silk_removed + found.silk_added) / all : 0;
}

double largest(std::span<const double> values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

std::size_t count_slack(std::span<const double> tension, double below) {
    return static_cast<std::size_t>(
        std::count_if(tension.begin(), tension.end(), [&](double t) { return t < below; }));
}

/// Threads that stay whole come first and in their order, those thickened cut in place.
double largest_change(const WebAtRest& plain, const WebChange& change, const WebAtRest& changed) {
    std::vector<std::uint8_t> touched(plain.segments.size(), 0);
    for (const std::uint32_t i : change.removed) touched[i] = 1;
    for (const WebChange::Thickened& part : change.thickened) touched[part.segment] = 1;
    double most = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < plain.segments.size(); ++i) {
        if (touched[i] != 0) continue;
        while (at < changed.segments.size() &&
               (changed.segments[at].a != plain.segments[i].a || changed.segments[at].b != plain.segments[i].b))
            ++at;
        if (at == changed.segments.size()) break;
        most = std::max(most, std::abs(changed.tension[at++] - plain.tension[i]));
    }
    return most;
}

/// Where a radius ends, by any point of it.
std::uint32_t end_of_radius(const std::vector<std::uint32_t>& next, std::uint32_t point) {
    while (next[point] != point) point = next[point];
    return point;
}

}  // namespace

Naturalness compare(const WebAtRest& plain, const WebChange& change, const WebAtRest& changed) {
    Naturalness found;
    count_silk(plain, change, found);
    const double before = largest(plain.tension), slack = -kSlack * before;
    if (before > 0) found.max_tension_ratio = largest(changed.tension) / before;
    found.tension_change = largest_change(plain, change, changed);
    const std::size_t was_slack = count_slack(plain.tension, slack),
                      is_slack = count_slack(changed.tension, slack);
    found.new_slack = is_slack - std::min(is_slack, was_slack);
    for (std::size_t i = 0; i < plain.points.size(); ++i)
        found.mean_shift += distance(plain.points[i], changed.points[i]);
    found.mean_shift /= static_cast<double>(std::max<std::size_t>(plain.points.size(), 1));
    found.spacing_distance = kolmogorov_distance(spacings(plain), spacings(changed));
    return found;
}

std::vector<double> spacings(const WebAtRest& web) {
    const std::vector<std::uint32_t> next = next_outward(web);
    std::vector<std::uint8_t> on_spiral(web.points.size(), 0);
    for (const std::uint32_t i : threads_of(web, "spiral"))
        on_spiral[web.segments[i].a] = on_spiral[web.segments[i].b] = 1;
    std::vector<std::pair<std::uint32_t, double>> crossings;  // radius, by its outer end; m from the hub
    for (std::uint32_t i = 0; i < web.points.size(); ++i)
        if (on_spiral[i] != 0)
            crossings.emplace_back(end_of_radius(next, i), distance(web.points[i], web.center));
    std::sort(crossings.begin(), crossings.end());
    std::vector<double> found;
    for (std::size_t i = 1; i < crossings.size(); ++i)
        if (crossings[i].first == crossings[i - 1].first)
            found.push_back(crossings[i].second - crossings[i - 1].second);
    std::sort(found.begin(), found.end());
    return found;
}

double kolmogorov_distance(std::span<const double> one, std::span<const double> other) {
    if (one.empty() || other.empty()) return one.empty() == other.empty() ? 0 : 1;
    double farthest = 0;
    std::size_t i = 0, j = 0;
    while (i < one.size() && j < other.size()) {
        const double at = std::min(one[i], other[j]);
        while (i < one.size() && one[i] <= at) ++i;
        while (j < other.size() && other[j] <= at) ++j;
        farthest = std::max(farthest, std::abs(static_cast<double>(i) / static_cast<double>(one.size()) -
                                               static_cast<double>(j) / static_cast<double>(other.size())));
    }
    return farthest;
}

}  // namespace orbweaver::inscription
