#include "measures.hpp"

#include <array>
#include <catch2/catch.hpp>

using namespace orbweaver::spider;

TEST_CASE("of several creatures counts are summed, and the worst is the worst", "[unit]") {
    std::array<CreatureMeasures, 2> both;
    both[0].frames = 10;
    both[0].unstable_frames = 1;
    both[0].penetrating_frames = 3;
    both[0].searches = 4;
    both[0].worst_penetration = 0.002;
    both[0].least_margin = 0.004;
    both[0].margins = 0.1;
    both[1].frames = 20;
    both[1].lost_frames = 2;
    both[1].worst_slip = 1e-3;
    both[1].worst_turn = 3;
    both[1].least_margin = -0.001;
    both[1].margins = 0.3;
    const CreatureMeasures sum = sum_of(both);
    CHECK(sum.frames == 30);
    CHECK(sum.lost_frames == 2);
    CHECK(sum.unstable_frames == 1);
    CHECK(sum.penetrating_frames == 3);
    CHECK(sum.searches == 4);
    CHECK(sum.worst_penetration == 0.002);
    CHECK(sum.worst_slip == 1e-3);
    CHECK(sum.worst_turn == 3);
    CHECK(sum.least_margin == -0.001);
    CHECK(sum.margins == Approx(0.4));
}
