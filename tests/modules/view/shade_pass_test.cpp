#include "shade_pass.hpp"

#include "build.hpp"
#include "frame_target.hpp"
#include "mesh_surface.hpp"
#include "offscreen.hpp"
#include "picture/color.hpp"
#include "plates.hpp"
#include "shapes.hpp"
#include "sky_pass.hpp"
#include "surface_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 64;
constexpr Camera kCamera{{0, 14, 0.001}, {0, 2, 0}, 45.23972915};  // 10 m of the cube's top, from above

/// The top of a cube 4 m high, lit evenly, and rods of 0.3 m along x above it. The light of its pixels, as a
/// share of what it is without.
class Studio {
public:
    Studio()
        : canvas_(kSize, kSize),
          ground_(canvas_.gl, kSize, kSize, FrameTarget::Depth::kept),
          picture_(canvas_.gl, kSize, kSize, FrameTarget::Depth::kept) {}

    void draw(double height, const Vec3& towards_key) {
        mesh::Validation validation;
        const auto data = mesh::build_surface_mesh(mesh::cube(40, 1), {}, "the test's cube", validation);
        const surface::MeshSurface cube(data.view(), std::nullopt, {});
        CubeSky sky;
        sky.size = 2;
        for (auto& face : sky.faces) face.assign(12, 0.5F);
        Camera camera = kCamera;
        camera.position.y += 18;
        camera.target.y += 18;
        ground_.bind();
        ground_.clear_depths();
        SurfacePass(canvas_.gl, cube, {{1, 1, 1}, 0}, sky_light(sky)).draw(camera, kSize, kSize);
        ground_.copy_to(picture_.framebuffer(), kSize, kSize);
        ground_.copy_depths_to(picture_);
        picture_.bind();
        test::Plates plates({{0, 20 + height, 0}});
        SkinMoves moves(canvas_.gl, plates);
        moves.update();
        ShadePass(canvas_.gl, plates.mesh(), {towards_key / norm(towards_key), {}})
            .draw(moves, ground_.depths(), camera, kSize, kSize);
        picture_.read(rgb_);
    }
    double left(double x, double z) const {
        const auto column = static_cast<std::size_t>((x / 10 + 0.5) * kSize);
        const auto row = static_cast<std::size_t>((z / 10 + 0.5) * kSize);
        return picture::linear_from_byte()[rgb_[3 * (row * kSize + column)]] / 0.5;
    }

private:
    test::Offscreen canvas_;
    FrameTarget ground_, picture_;
    std::vector<std::uint8_t> rgb_;
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
