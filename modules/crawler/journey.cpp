#include "journey.hpp"

#include <cmath>

namespace orbweaver::crawler {

void Journey::go_on(const Vec3& center, double now, double all) noexcept {
    constexpr double kRounding = 1e-9;  // of a cycle
    const double ended = std::floor(std::abs(all) + kRounding);
    if (ended <= cycle) return;
    if (cycle > 0) {
        way += distance(mark, center);
        time += now - mark_time;
        cycles += ended - cycle;
    }
    mark = center;
    mark_time = now;
    cycle = ended;
}

double Journey::speed(const Vec3& center, double now) const noexcept {
    if (time > 0) return way / time;
    return now > 0 ? distance(start, center) / now : 0;
}

double Journey::way_a_cycle(const Vec3& center, double all) const noexcept {
    if (cycles > 0) return way / cycles;
    return all != 0 ? distance(start, center) / std::abs(all) : 0;
}

}  // namespace orbweaver::crawler
