#include <catch2/catch.hpp>
#include <cmath>

#include "crawling_bodies.hpp"
#include "sanitized.hpp"
#include "spider/land.hpp"

// Whole bodies on grounds other than a floor, in the air, and holding on.

using namespace orbweaver;
using namespace orbweaver::crawler;
using namespace crawling;

TEST_CASE("a body that lies over a cliff's edge bends down round it and gets into nothing", "[unit]") {
    Setup setup = bar();
    setup.build.segments = 20;
    setup.build.length = 0.1;
    setup.make_springs(1, 1, 4e-3);
    const Cliff cliff{0, 0.01, 0.01, 0.05};
    setup.ground = cliff;
    setup.friction = {FrictionLaw::coulomb, 0.3, 0.3, 0.3};
    Run run(setup);
    for (int i = 0; i < repetitions(60); ++i) {
        run.advance();
        for (const Vec3& each : run.x) REQUIRE(cliff.touch(each, 0).depth <= 2 * kNear * setup.build.width);
    }
    if (kSanitized) return;
    const Vec3 head = ring_middle(&run.x[run.lattice().point(0, 20)]);
    CHECK(head.y < -0.01);
}

TEST_CASE("a level mesh is the same ground as a floor", "[unit]") {
    const land::Land land(land::crates_on_a_floor());
    Setup setup = worm(0.1, 0.1, 0.3);
    setup.period = 0.3;
    setup.poses = {{{0.3, setup.build.width / 2, -0.3}, {0, 0, 1}, {0, 1, 0}}};
    Run on_floor(setup);
    setup.ground = SurfaceGround(land.surface(), 84, 0.02, nullptr);
    Run on_mesh(setup);
    on_floor.advance(repetitions(2) * setup.period);
    on_mesh.advance(repetitions(2) * setup.period);
    // Usual friction is that of the floor; the face is level but for rounding of its normal.
    CHECK(land.surface().grip(0).friction == SurfaceGround::kUsualFriction);
    CHECK(largest_distance(on_floor.x, on_mesh.x) < 1e-9);
    CHECK(on_mesh.books().contact == Approx(on_floor.books().contact).epsilon(1e-6));
}

TEST_CASE("grip of a surface multiplies the friction of bodies on it", "[unit]") {
    surface::GripOverrides grips;
    grips.all.friction = 1.5 * SurfaceGround::kUsualFriction;
    const land::Land land(land::crates_on_a_floor(), grips);
    Setup setup = on_slope(0, 5, {FrictionLaw::coulomb, 0.2, 0.5, 0.3}, "symplectic_euler");
    setup.poses = {{{0.3, setup.build.width / 2, -0.3}, {1, 0, 0}, {0, 1, 0}}};
    setup.ground = SurfaceGround(land.surface(), 44, 0.02, nullptr);
    Run run(setup);
    run.advance(0.2);
    const Vec3 speed = run.velocity();
    run.advance(0.1);
    CHECK(norm(run.velocity() - speed) / 0.1 == Approx(5 - 1.5 * 0.3 * kG).epsilon(0.01));
}

TEST_CASE("a body that flies takes the curvature that its muscles ask for", "[unit]") {
    for (const double turn : {8.0, -5.0}) {
        Setup setup = worm(0, 0, 0);
        setup.build.segments = 6;  // few, so that vibrations die out soon
        setup.build.length = 0.03;
        setup.make_springs(5, 1.6, 2e-3);
        setup.gravity = {};
        setup.ground = Floor{-1};
        setup.period = 0.3;
        setup.effort.turn = turn;
        Run run(setup);
        run.advance(3 * setup.period);
        for (std::uint32_t ring = 1; ring < setup.build.segments; ++ring) {
            const auto middle = [&](std::uint32_t of) {
                return ring_middle(&run.x[run.lattice().point(0, of)]);
            };
            const Vec3 before = middle(ring) - middle(ring - 1), after = middle(ring + 1) - middle(ring);
            const double angle = std::asin(cross(before, after).y / (norm(before) * norm(after)));
            CHECK(angle / setup.build.segment() == Approx(turn).epsilon(0.01));  // y is up: to the left
        }
        CHECK(run.books().contact == 0);
        CHECK(norm(run.center() - Vec3{0, setup.build.width / 2, 0}) < 1e-13);
    }
}

TEST_CASE("what holds on hangs from a ceiling that it can bear, and else falls off", "[unit]") {
    // Gravity pulls away from the floor. One side of the four corners hangs on to it for all of them.
    for (const double adhesion : {0.0, 4.0, 8.0, 20.0}) {
        Setup setup = bar();
        setup.gravity = {0, 5, 0};
        setup.friction.adhesion = adhesion;
        setup.frame = 1e-3;
        Run run(setup);
        run.advance(0.05);
        const bool holds = adhesion > 2 * 2 * 5;  // a sudden weight pulls twice as much as it does later
        if (adhesion >= 20) CHECK(run.center().y < 0.55 * setup.build.width);
        if (adhesion < 2 * 5) CHECK(run.center().y > 0.6 * setup.build.width);
        if (holds) CHECK(run.books().contact > 0);
    }
}

TEST_CASE("rings that muscles hump let go of the ground, and the rest hold on to it", "[unit]") {
    Setup setup = worm(0, 0, 0);
    setup.make_springs(1, 1, 1);  // so limp that every point is alone
    setup.gait = "caterpillar";
    setup.waves = 1.7;
    setup.effort.lift = 1e-3;
    setup.gravity = {0, 5, 0};
    setup.friction.adhesion = 20;
    setup.frame = 1e-3;
    setup.step = 1e-4;  // in which nothing gets farther than the ground is felt
    setup.period = 10;  // in which the wave goes nowhere soon
    Run run(setup);
    run.advance(0.02);
    const double flown = 0.5 * 5 * 0.02 * 0.02;
    std::vector<Flex> flexes(setup.build.segments);
    Waves(*find_gait(setup.gait), WaveForm::sine, setup.waves, setup.build.segments)
        .flex(0.002, {0, 0, 1, 0}, flexes);
    int humped = 0;
    for (std::size_t ring = 0; ring <= setup.build.segments; ++ring) {
        const double bent = flexes[ring > 0 ? ring - 1 : 0].up + flexes[std::min<std::size_t>(ring, 19)].up;
        if (std::abs(bent) < 0.05) continue;  // which may have changed
        if (bent < 0) ++humped;
        for (std::size_t j = 0; j < 2; ++j)
            CHECK(run.x[4 * ring + j].y == Approx(bent < 0 ? flown : 0).margin(0.15 * flown));
    }
    CHECK(humped > 5);
    CHECK(humped < 15);
}

TEST_CASE("every ring of a bent body rubs along its own spine", "[unit]") {
    Setup setup = bar();
    setup.make_springs(1, 1, 1);  // so limp that only the ground acts
    setup.friction = {FrictionLaw::coulomb, 0.1, 0.4, 0.8};
    setup.frame = setup.step = 1e-3;
    Run run(setup);
    std::vector<Vec3> middles;
    for (std::size_t ring = 0; ring <= setup.build.segments; ++ring) {
        const double angle = 0.3 * static_cast<double>(ring), c = std::cos(angle), s = std::sin(angle);
        middles.push_back({0.02 * s, 0, 0.02 * c});
        for (std::size_t j = 0; j < kCorners; ++j) {
            const double width = setup.build.width;
            run.x[4 * ring + j] =
                middles[ring] + width * kRight[j] * Vec3{s, 0, c} + Vec3{0, width * (kUp[j] + 0.5), 0};
            run.v[4 * ring + j] = {1, 0, 0};
            if (kUp[j] < 0) run.reaction[4 * ring + j] = {0, kG * setup.build.point_mass(), 0};
        }
    }
    run.advance();
    for (std::size_t ring = 0; ring <= setup.build.segments; ++ring) {
        Vec3 spine =
            middles[std::min<std::size_t>(ring + 1, setup.build.segments)] - middles[ring > 0 ? ring - 1 : 0];
        spine = spine / norm(spine);
        const Vec3 side = cross({0, 1, 0}, spine);
        for (std::size_t j = 0; j < kCorners; ++j) {
            if (kUp[j] > 0) continue;
            const Vec3 v = run.v[4 * ring + j];
            const double along = dot(v, spine), aside = dot(v, side), pressing = kG * setup.step / norm(v);
            const Vec3 expected =
                v + pressing * (along < 0 ? 0.4 : 0.1) * along * spine + pressing * 0.8 * aside * side;
            // Impulses are some 1e-3 m/s; the spine moves by 1e-6 of itself, and springs pull a little.
            CHECK(distance(expected, {1, 0, 0}) < 1e-5);
        }
    }
}
