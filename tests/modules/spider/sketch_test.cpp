#include "sketch.hpp"

#include <algorithm>

#include "creatures.hpp"
#include "land.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;
using land::Land;

namespace {

using Color = std::array<float, 3>;
constexpr Color kUnderfoot{1, 0.85F, 0.1F}, kSupport{1, 1, 1}, kStands{0.25F, 0.95F, 0.3F},
    kSwings{1, 0.55F, 0.1F};

/// A huntsman that has walked on a floor for so many frames.
struct Walker {
    Species species = creature("huntsman");
    Conduct conduct;
    Land land{mesh::cube(0.6, 3)};
    CreatureState state;

    explicit Walker(int frames) {
        conduct.species = &species;
        conduct.gait = find_gait("tetrapod");
        conduct.path = find_stride_path("cycloid");
        conduct.solver = find_leg_solver("half_jacobian");
        conduct.pace = {0.15, 0.01, 0.027, 0.75, 0.62};
        conduct.rests = false;
        const RandomStream random(1, "sketch");
        CreatureMeasures measures;
        place_creature(land.surface(), conduct, land.stand({0.05, 0.3, 0.03}, {0, 1, 0}, {1, 0, 0}), state);
        for (int i = 0; i < frames; ++i)
            advance_creature(land.surface(), conduct, {random, {}}, 1.0 / 60, state, measures);
    }
    std::vector<SketchLine> lines(const Color& color) const {
        std::vector<SketchLine> all, some;
        add_sketch(land.surface(), conduct, state, all);
        std::ranges::copy_if(all, std::back_inserter(some),
                             [&](const SketchLine& l) { return l.color == color; });
        return some;
    }
};

}  // namespace

TEST_CASE("the polygon underfoot is drawn by its rim, not by the cuts within", "[unit]") {
    const auto rim = Walker(0).lines(kUnderfoot);
    REQUIRE(rim.size() == 4);  // a square of two triangles
    for (const SketchLine& line : rim) {
        CHECK(distance(line.a, line.b) == Approx(0.2));
        CHECK(line.a.y == Approx(0.3));
    }
}

TEST_CASE("feet that stand are joined around the body; those that swing show where they go", "[unit]") {
    const Walker walker(40);
    std::vector<Vec3> standing;
    std::size_t swinging = 0;
    for (std::size_t leg = 0; leg < 8; ++leg) {
        if (walker.state.progress[leg] < 0)
            standing.push_back(walker.state.feet[leg].place);
        else
            ++swinging;
    }
    REQUIRE(swinging > 0);
    REQUIRE(standing.size() + swinging == 8);
    const auto support = walker.lines(kSupport);
    for (const Vec3& foot : standing) {
        const auto from = [&](const SketchLine& line) { return line.a == foot; };
        const auto to = [&](const SketchLine& line) { return line.b == foot; };
        CHECK(std::ranges::count_if(support, from) == 1);
        CHECK(std::ranges::count_if(support, to) == 1);
    }
    CHECK(walker.lines(kStands).size() == 4 * standing.size());  // a mark of four lines each
    const auto swings = walker.lines(kSwings);
    for (std::size_t leg = 0; leg < 8; ++leg) {
        if (walker.state.progress[leg] < 0) continue;
        const Swing& swing = walker.state.feet[leg].swing;
        CHECK(std::ranges::any_of(swings,
                                  [&](const SketchLine& l) { return distance(l.a, swing.start) < 1e-12; }));
        CHECK(
            std::ranges::any_of(swings, [&](const SketchLine& l) { return distance(l.b, swing.end) < 1e-12; }));
    }
}

TEST_CASE("bones turn from green to red as their joints leave comfort for their limits", "[unit]") {
    Walker walker(0);
    const Color green{0.15F, 0.85F, 0.15F};
    const auto& limbs = walker.species.limbs;
    for (std::size_t i = 0; i < limbs.size(); ++i) walker.state.poses[i] = rest_pose(limbs[i].leg);
    const std::size_t comfortable = walker.lines(green).size();
    CHECK(comfortable == 8 * kBones);
    walker.state.poses[0][kPitch + 2] = limbs[0].leg.min[kPitch + 2];
    walker.state.poses[2][kYaw] = limbs[2].leg.max[kYaw];
    CHECK(walker.lines(green).size() == comfortable - 2);
    std::vector<SketchLine> all;
    add_sketch(walker.land.surface(), walker.conduct, walker.state, all);
    const auto red = [](const SketchLine& l) { return l.color[0] > 0.999F && l.color[1] < 0.001F; };
    CHECK(std::ranges::count_if(all, red) == 2);
}
