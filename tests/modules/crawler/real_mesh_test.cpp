#include "real_mesh.hpp"

#include <catch2/catch.hpp>

#include "crawling_bodies.hpp"
#include "sanitized.hpp"
#include "spider/land.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;
using namespace crawling;

TEST_CASE("a snake falls onto the bunny's back, winds along it and gets into it nowhere", "[extreme]") {
    const land::Land land(real_mesh("stanford-bunny", 2));
    const Surface& bunny = land.surface();
    const SurfaceHit back = bunny.first_hit({{0.2, 5, 0}, {0, -1, 0}});
    REQUIRE(back.answer == Answer::found);
    Setup setup;
    setup.build.segments = 24;
    setup.build.length = 0.5;
    setup.build.width = 0.02;
    setup.make_springs(0.5, 3.5, 1e-3);
    setup.gait = "undulation";
    setup.waves = 1;
    setup.effort.bend = 7 / setup.build.length;
    setup.period = 1;
    setup.friction = {FrictionLaw::coulomb, 0.6, 1.2, 2};
    setup.ground = SurfaceGround(bunny, std::size_t{kCorners} * 25, setup.build.width, nullptr);
    setup.poses = {{bunny.position(back.at) + Vec3{0, 0.04, 0}, {1, 0, 0}, {0, 1, 0}}};
    Run run(setup);
    double touched = 0;
    for (int frame = 0; frame < repetitions(120); ++frame) {
        run.advance();
        for (const Vec3& each : run.x) {
            const SurfaceHit nearest = bunny.closest_point(each, 1);
            REQUIRE(nearest.answer == Answer::found);
            const double above = dot(each - bunny.position(nearest.at), bunny.normal(nearest.at.face));
            CHECK(above > -setup.build.width / 4);  // a point knows one plane of it a frame
            if (above < 1e-4) ++touched;
        }
    }
    if (!kSanitized) CHECK(touched > 120);  // a point a frame: it lies on the back's ridge
    if (!kSanitized) CHECK(run.books().friction > 0);
}
