#include "support.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::spider {
namespace {

/// Twice the area of a triangle: above 0 where c is on the left of the way from a to b.
double left_of(const SupportPoint& a, const SupportPoint& b, const SupportPoint& c) noexcept {
    return (b.right - a.right) * (c.forward - a.forward) - (b.forward - a.forward) * (c.right - a.right);
}

double square_between(const SupportPoint& a, const SupportPoint& b) noexcept {
    const double forward = b.forward - a.forward, right = b.right - a.right;
    return forward * forward + right * right;
}

}  // namespace

Support support_of(std::span<const SupportPoint> feet) noexcept {
    constexpr Support kNone{-HUGE_VAL, {}};
    if (feet.size() < 3) return kNone;
    // Round the hull by gift wrapping (Jarvis 1973), all feet on the left of each side.
    const auto first = static_cast<std::size_t>(
        std::min_element(feet.begin(), feet.end(),
                         [](const SupportPoint& a, const SupportPoint& b) { return a.forward < b.forward; }) -
        feet.begin());
    Support support{HUGE_VAL, {}};
    std::size_t at = first;
    for (std::size_t sides = 0; sides < feet.size(); ++sides) {
        std::size_t next = at;
        for (std::size_t i = 0; i < feet.size(); ++i) {
            const double left = left_of(feet[at], feet[next], feet[i]);
            if (left < 0 ||
                (left == 0 && square_between(feet[at], feet[i]) > square_between(feet[at], feet[next])))
                next = i;
        }
        if (next == at) return kNone;  // all in one place
        const SupportPoint &a = feet[at], &b = feet[next];
        const double length = std::sqrt(square_between(a, b)), margin = left_of(a, b, {}) / length;
        if (margin < support.margin)
            support = {margin, {(b.right - a.right) / length, (a.forward - b.forward) / length}};
        at = next;
        if (at == first) break;
    }
    return support;
}

}  // namespace orbweaver::spider
