#include "skin_pass.hpp"

#include <algorithm>

#include "frame_target.hpp"
#include "offscreen.hpp"
#include "plates.hpp"
#include "sky_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 64;
constexpr Camera kCamera{{0, 0, 10}, {0, 0, 0}, 53.13010235415598};  // 10 m high at the plates

CubeSky even(float light) {
    CubeSky sky;
    sky.size = 2;
    for (auto& face : sky.faces) face.assign(12, light);
    return sky;
}

/// A picture of 10 x 10 m before a black sky.
class Studio {
public:
    Studio() : canvas_(kSize, kSize), target_(canvas_.gl, kSize, kSize, FrameTarget::Depth::kept) {}

    void draw(const std::vector<Skins*>& all) {
        const CubeSky sky = even(0.5F);
        target_.bind();
        target_.clear_depths();
        SkyPass(canvas_.gl, even(0)).draw(kCamera, 1);
        for (Skins* skins : all) {
            SkinMoves moves(canvas_.gl, *skins);
            const SkinPass pass(canvas_.gl, skins->mesh(), sky_light(sky), key_light(sky));
            moves.update();
            pass.draw(moves, kCamera, kSize, kSize);
        }
        target_.read(rgb_);
    }
    int red(double x, double y) const { return channel(x, y, 0); }
    int green(double x, double y) const { return channel(x, y, 1); }

private:
    int channel(double x, double y, std::size_t c) const {
        const auto column = static_cast<std::size_t>((x / 10 + 0.5) * kSize);
        const auto row = static_cast<std::size_t>((0.5 - y / 10) * kSize);
        return rgb_[3 * (row * kSize + column) + c];
    }
    test::Offscreen canvas_;
    FrameTarget target_;
    std::vector<std::uint8_t> rgb_;
};

}  // namespace

TEST_CASE("each creature of a kind is drawn where its bones are", "[image]") {
    Studio studio;
    test::Plates plates({{-3, 2, 0}, {3, -2, 0}});
    studio.draw({&plates});
    for (const auto& [x, y] : {std::pair{-3.0, 2.0}, {-2.2, 1.2}, {3.0, -2.0}, {3.8, -2.8}}) {
        CAPTURE(x, y);
        CHECK(studio.red(x, y) > 100);
        CHECK(studio.green(x, y) < 60);
    }
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-3.0, -2.0}, {-1.7, 2.0}, {4.3, -2.0}}) {
        CAPTURE(x, y);
        CHECK(studio.red(x, y) == 0);
    }
}

TEST_CASE("skin between two bones goes as far with each as it weighs", "[image]") {
    Studio studio;
    test::Plates plates({{0, 0, 0}});
    plates.now[1].at = {2, 0, 0};  // the right side goes on by 2 m: the plate is 4 m wide
    studio.draw({&plates});
    CHECK(studio.red(2.8, 0) > 100);
    CHECK(studio.red(3.2, 0) == 0);
    for (SkinVertex& vertex : plates.vertices) vertex.weights = {0.5F, 0.5F};
    studio.draw({&plates});  // all of it by half of that
    CHECK(studio.red(1.8, 0) > 100);
    CHECK(studio.red(2.2, 0) == 0);
    CHECK(studio.red(0.2, 0) > 100);
    CHECK(studio.red(-0.2, 0) == 0);
}

TEST_CASE("nearer skin hides what is behind it, whichever is drawn first", "[image]") {
    Studio studio;
    test::Plates red({{-0.5, 0, 1}}), green({{0.5, 0, -1}});
    for (SkinVertex& vertex : green.vertices) vertex.color = {0, 1, 0};
    for (const auto& order : {std::vector<Skins*>{&red, &green}, std::vector<Skins*>{&green, &red}}) {
        studio.draw(order);
        CHECK(studio.red(0, 0) > 100);
        CHECK(studio.green(0, 0) < 60);
        CHECK(studio.green(1.2, 0) > 100);
    }
}

TEST_CASE("backs of skins are not drawn", "[image]") {
    Studio studio;
    test::Plates plates({{0, 0, 0}});
    for (SkinMove& move : plates.now) {
        move.x = {-1, 0, 0};
        move.z = {0, 0, -1};
    }
    studio.draw({&plates});
    CHECK(studio.red(0.5, 0.5) == 0);
}

TEST_CASE("nobody is drawn where there is nobody", "[image]") {
    Studio studio;
    test::Plates plates({});
    studio.draw({&plates});
    CHECK(studio.red(0, 0) == 0);
}
