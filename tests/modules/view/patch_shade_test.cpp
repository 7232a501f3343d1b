#include "patch_shade.hpp"

#include "ground.hpp"
#include "tubes.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

const double kOctagon = (2 + std::sqrt(0.5)) / 3;  // the skin's radius where the points' is 1

class Studio {
public:
    void draw(Patches& patches, const Vec3& towards_key) {
        ground_.draw([&](const Gl& gl, GLuint depths, const Camera& camera, int size) {
            PatchPoints points(gl, patches);
            points.update();
            PatchShade(gl, {towards_key / norm(towards_key), {}}).draw(points, depths, camera, size, size);
        });
    }
    double left(double x, double z) const { return ground_.left(x, z); }

private:
    test::Ground ground_;
};

}  // namespace

TEST_CASE("the rods of a tube follow its middle, as thick as its skin", "[unit]") {
    test::Tubes tubes({{0, 0, 0}, {0, 5, 1}}, 9, 8, 0.25);
    const auto rods = tube_rods(tubes.layout(), tubes.points());
    REQUIRE(rods.size() == 2 * 6);
    for (std::size_t i = 0; i < rods.size(); ++i) {
        const Vec3 at = i < 6 ? Vec3{} : Vec3{0, 5, 1};
        const double x = static_cast<double>(i % 6) - 3;
        CHECK(distance(rods[i].from, at + Vec3{x, 0, 0}) < 1e-9);
        CHECK(distance(rods[i].to, at + Vec3{x + 1, 0, 0}) < 1e-9);
        CHECK(rods[i].radius == Approx(0.25 * kOctagon));
    }
}

TEST_CASE("a thick tube has fewer rods, a long one as many as can be drawn, from end to end", "[unit]") {
    test::Tubes thick({{0, 0, 0}}, 9, 8);
    CHECK(tube_rods(thick.layout(), thick.points()).size() == 2);  // 6 m long, 1.8 m thick
    for (const Vec3& end : {tube_rods(thick.layout(), thick.points()).front().from,
                            -tube_rods(thick.layout(), thick.points()).back().to})
        CHECK(distance(end, {-3, 0, 0}) < 1e-9);
    test::Tubes tube({{0, 0, 0}}, 103, 8);
    for (std::size_t ring = 60; ring < 103; ++ring)
        for (Vec3& point : tube.ring(ring)) point = {point.x, 2 * point.y, 2 * point.z};
    const auto rods = tube_rods(tube.layout(), tube.points());
    REQUIRE(rods.size() == 24);
    CHECK(rods.front().from.x == Approx(-50));
    CHECK(rods.back().to.x == Approx(50));
    for (std::size_t i = 0; i + 1 < rods.size(); ++i) CHECK(distance(rods[i].to, rods[i + 1].from) == 0);
    CHECK(rods.front().radius == Approx(kOctagon));
    CHECK(rods.back().radius == Approx(2 * kOctagon));
}

TEST_CASE("a piece of a tube without length has no rod", "[unit]") {
    test::Tubes tube({{0, 0, 0}}, 4, 8);
    CHECK(tube_rods(tube.layout(), tube.points()).front().radius > 0);
    for (Vec3& point : tube.now) point.x = 0;
    CHECK(tube_rods(tube.layout(), tube.points()).front().radius == 0);
}

TEST_CASE("a tube on a surface shades it beside it, however many rings it has", "[image]") {
    Studio studio;
    test::Tubes few({{0, 20.3, 0}}, 5, 8, 0.3 / kOctagon), many({{0, 20.3, 0}}, 21, 8, 0.3 / kOctagon);
    for (Vec3& point : few.now) point.x *= 2;  // rings 2 m apart: skin from -2 to 2 m
    for (Vec3& point : many.now) point.x *= 2 / 9.0;
    studio.draw(few, {0, -1, 0});  // no key light
    const double beside = studio.left(0.3, 0.4), joint = studio.left(0, 0.4), beyond = studio.left(3.3, 0);
    CHECK(beside < 0.9);
    CHECK(joint == Approx(beside).margin(0.02));
    CHECK(studio.left(0, 0) < beside - 0.1);
    CHECK(studio.left(0, 1) > beside + 0.05);
    CHECK(beyond > 0.97);
    CHECK(studio.left(0, 3) == Approx(1).margin(0.01));
    studio.draw(many, {0, -1, 0});
    CHECK(studio.left(0.3, 0.4) == Approx(beside).margin(0.03));
    CHECK(studio.left(3.3, 0) > 0.97);
}

TEST_CASE("the key light throws a tube's shadow to its other side", "[image]") {
    Studio studio;
    for (const std::size_t rings : {5U, 21U}) {
        CAPTURE(rings);
        test::Tubes tube({{0, 21, 0}}, rings, 8, 0.3 / kOctagon);
        for (Vec3& point : tube.now) point.x *= 4.0 / static_cast<double>(rings - 3);
        studio.draw(tube, {0, 1, -1});  // from the back
        CHECK(studio.left(0, 1) < 0.65);
        CHECK(studio.left(0, 1) > 0.4);
        CHECK(studio.left(1.1, 1) == Approx(studio.left(0, 1)).margin(0.05));
        CHECK(studio.left(0, -1) > 0.9);
        CHECK(studio.left(3, 1) > 0.95);
        studio.draw(tube, {0, -1, 1});
        CHECK(studio.left(0, 1) > 0.9);
    }
}

TEST_CASE("no shade is thrown where there are no bodies of patches", "[image]") {
    Studio studio;
    test::Tubes none({}, 9, 8);
    studio.draw(none, {0, 1, 0});
    CHECK(studio.left(0, 0) == Approx(1).margin(0.01));
}
