#include "sweep.hpp"

#include <algorithm>

namespace orbweaver::peers {
namespace {

constexpr double kRepeating = 4;  // s, for which a run is repeated; the least time is the least disturbed

bool is_stuck(const std::vector<Point>& points) {
    constexpr std::ptrdiff_t kRungs = 6;
    const auto best =
        std::min_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.error < b.error; });
    return points.end() - best > kRungs;
}

std::optional<Point> cheapest_within(const std::vector<Point>& points, double target) {
    std::optional<Point> best;
    for (const Point& point : points)
        if (point.error <= target && (!best || point.seconds < best->seconds)) best = point;
    return best;
}

void repeat(const Contender& contender, Point& point) {
    for (double spent = point.seconds; spent < kRepeating;) {
        const double seconds = contender.run(point.setting).seconds;
        point.seconds = std::min(point.seconds, seconds);
        spent += seconds;
    }
}

}  // namespace

Point Sweep::most_accurate() const {
    return *std::min_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.error < b.error; });
}

Sweep sweep(const Contender& contender, const std::vector<Vec3>& exact, double patience) {
    Sweep result{contender, {}, {}};
    auto& points = result.points;
    double setting = contender.first;
    do {
        const Run run = contender.run(setting);
        points.push_back({setting, largest_error(run.x, exact), run.seconds});
        setting *= contender.ratio;
    } while (points.back().error > kTargets.back() && !is_stuck(points) && points.back().seconds < patience);
    for (std::size_t i = 0; i < kTargets.size(); ++i) {
        result.cheapest[i] = cheapest_within(points, kTargets[i]);
        if (result.cheapest[i]) repeat(contender, *result.cheapest[i]);
    }
    return result;
}

}  // namespace orbweaver::peers
