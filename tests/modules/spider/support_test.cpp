#include "support.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

/// By every line through two feet that has all others on one side.
double margin_by_all_lines(const std::vector<SupportPoint>& feet) {
    double least = HUGE_VAL;
    for (const SupportPoint& a : feet)
        for (const SupportPoint& b : feet) {
            const double forward = b.forward - a.forward, right = b.right - a.right;
            const double length = std::hypot(forward, right);
            if (length == 0) continue;
            const auto inward = [&](const SupportPoint& p) {
                return (right * (p.forward - a.forward) - forward * (p.right - a.right)) / length;
            };
            bool is_side = true;
            for (const SupportPoint& c : feet) is_side = is_side && inward(c) >= -1e-15;
            if (is_side) least = std::min(least, inward({}));
        }
    return least;
}

}  // namespace

TEST_CASE("the margin of a square is the distance to its nearest side, and leads inwards", "[unit]") {
    const std::vector<SupportPoint> square{{3, -2}, {3, 2}, {-1, 2}, {-1, -2}};
    const Support support = support_of(square);
    CHECK(support.margin == Approx(1));
    CHECK(support.inward.forward == Approx(1));
    CHECK(support.inward.right == Approx(0).margin(1e-15));
    std::vector<SupportPoint> ahead = square;
    for (SupportPoint& each : ahead) each.forward += 1.5;  // now all are ahead of the center of mass
    CHECK(support_of(ahead).margin == Approx(-0.5));
}

TEST_CASE("the margin of any feet is what trying all lines says", "[unit]") {
    const RandomStream random(3, "feet");
    std::uint64_t n = 0;
    int inside = 0;
    for (int i = 0; i < 2000; ++i) {
        std::vector<SupportPoint> feet(3 + static_cast<std::size_t>(i) % 6);
        for (SupportPoint& foot : feet) foot = {random.uniform(n++, -1, 1), random.uniform(n++, -1, 1)};
        const double margin = support_of(feet).margin;
        CHECK(margin == Approx(margin_by_all_lines(feet)).margin(1e-12));
        inside += margin >= 0 ? 1 : 0;
    }
    CHECK(inside > 500);
    CHECK(inside < 1500);
}

TEST_CASE("feet that span nothing hold nobody", "[unit]") {
    CHECK(support_of(std::vector<SupportPoint>{}).margin == -HUGE_VAL);
    CHECK(support_of(std::vector<SupportPoint>{{1, 0}, {-1, 0}}).margin == -HUGE_VAL);
    CHECK(support_of(std::vector<SupportPoint>{{1, 1}, {1, 1}, {1, 1}}).margin == -HUGE_VAL);
    CHECK(support_of(std::vector<SupportPoint>{{1, 0}, {0, 0}, {-1, 0}}).margin <= 0);
}
