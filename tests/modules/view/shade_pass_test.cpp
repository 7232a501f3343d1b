#include "ground.hpp"
#include "plates.hpp"
#include "skin_shade.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

/// Rods of 0.3 m along x above the ground.
class Studio {
public:
    void draw(double height, const Vec3& towards_key) {
        ground_.draw([&](const Gl& gl, GLuint depths, const Camera& camera, int size) {
            test::Plates plates({{0, 20 + height, 0}});
            SkinMoves moves(gl, plates);
            moves.update();
            SkinShade(gl, plates.mesh(), {towards_key / norm(towards_key), {}})
                .draw(moves, depths, camera, size, size);
        });
    }
    double left(double x, double z) const { return ground_.left(x, z); }

private:
    test::Ground ground_;
};

}  // namespace

TEST_CASE("what lies on a surface shades it, the more the nearer", "[image]") {
    Studio studio;
    studio.draw(0.3, {0, -1, 0});  // no key light
    CHECK(studio.left(0, 0) < 0.6);
    CHECK(studio.left(0, 0.8) > studio.left(0, 0));
    CHECK(studio.left(0, 0.8) < 0.97);
    CHECK(studio.left(0, 3) == Approx(1).margin(0.01));  // a shade of 8 bits
    CHECK(studio.left(4, 0) == Approx(1).margin(0.01));
    const double touching = studio.left(0, 0);
    studio.draw(1.2, {0, -1, 0});
    CHECK(studio.left(0, 0) > touching);
    CHECK(studio.left(0, 0) < 0.99);
}

TEST_CASE("a key light from one side throws a shadow to the other", "[image]") {
    Studio studio;
    studio.draw(1, {0, 1, -1});  // from the back: the shadow falls 1 m to the front
    const double joint = studio.left(0, 1);
    CHECK(joint < 0.65);
    CHECK(studio.left(0.6, 1) == Approx(joint).margin(0.1));  // all along the rods, joined as if they were one
    CHECK(studio.left(0, -1) > 0.95);
    CHECK(studio.left(2, 1) > 0.95);  // beyond their end
    CHECK(studio.left(0, 3) > 0.95);
    studio.draw(1, {0, -1, 1});  // from below the surface: none
    CHECK(studio.left(0, 1) > 0.95);
}
