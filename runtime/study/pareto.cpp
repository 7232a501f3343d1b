#include "study/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::study {

namespace {

int decade_above(double error) { return static_cast<int>(std::ceil(std::log10(error) - 1e-9)); }

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const CostError> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (std::isfinite(points[i].error)) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                                : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= least) continue;
        least = points[i].error;
        front.push_back(i);
    }
    return front;
}

std::optional<std::size_t> cheapest_within(std::span<const CostError> points, double bound) {
    constexpr double kRounding = 1 + 1e-9;  // an error of 1e-4 is within 1e-4
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].error <= bound * kRounding && (!best || points[i].cost < points[*best].cost)) best = i;
    return best;
}

std::vector<int> decades(std::span<const CostError> points) {
    std::vector<int> found;
    for (const CostError& point : points)
        if (std::isfinite(point.error) && point.error > 0) found.push_back(decade_above(point.error));
    if (found.empty()) return {};
    const auto [least, most] = std::minmax_element(found.begin(), found.end());
    std::vector<int> all;
    for (int decade = *most; decade >= *least; --decade) all.push_back(decade);
    return all;
}

}  // namespace orbweaver::study
