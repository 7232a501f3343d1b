#include "journey.hpp"

#include <cmath>

namespace orbweaver::crawler {

void Journey::go_on(const Vec3& center, double now, double cycles) noexcept {
    constexpr double kRounding = 1e-9;  // of a cycle
    const double ended = std::floor(std::abs(cycles) + kRounding);
    if (ended <= cycle) return;
    if (cycle > 0) {
        way += distance(mark, center);
        time += now - mark_time;
    }
    mark = center;
    mark_time = now;
    cycle = ended;
}

double Journey::speed(const Vec3& center, double now) const noexcept {
    if (time > 0) return way / time;
    return now > mark_time ? distance(mark, center) / (now - mark_time) : 0;
}

}  // namespace orbweaver::crawler
