#include "sketch_pass.hpp"

#include <vector>

#include "frame_target.hpp"
#include "offscreen.hpp"
#include "sky_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 64;
constexpr Camera kCamera{{0, 0, 10}, {0, 0, 0}, 53.13010235415598};  // 10 m high at the origin

struct Drawing final : Sketch {
    std::vector<SketchLine> all;
    bool wanted() const noexcept override { return true; }
    std::span<const SketchLine> lines() override { return all; }
};

}  // namespace

TEST_CASE("lines are drawn three pixels wide in their own colors, over whatever depths there are", "[image]") {
    test::Offscreen canvas(kSize, kSize);
    FrameTarget target(canvas.gl, kSize, kSize, FrameTarget::Depth::kept);
    CubeSky night;
    night.size = 1;
    for (auto& face : night.faces) face.assign(3, 0.0F);
    Drawing drawing;
    SketchPass pass(canvas.gl, drawing);
    const auto draw = [&] {
        std::vector<std::uint8_t> rgb;
        target.bind();
        SkyPass(canvas.gl, night).draw(kCamera, 1);
        pass.draw(kCamera, kSize, kSize);
        target.read(rgb);
        return rgb;
    };
    for (const std::uint8_t shade : draw()) REQUIRE(shade == 0);  // nothing to tell
    drawing.all = {{{-4, 0, 0}, {4, 0, 0}, {1, 0, 0}}, {{2, -4, -1}, {2, 4, -1}, {0, 0.5F, 1}}};
    const auto rgb = draw();
    const auto at = [&](double x, double y, std::size_t c) {
        const auto column = static_cast<std::size_t>((x / 10 + 0.5) * kSize);
        const auto row = static_cast<std::size_t>((0.5 - y / 10) * kSize);
        return rgb[3 * (row * kSize + column) + c];
    };
    CHECK(at(-2, 0.01, 0) == 255);
    CHECK(at(-2, 0.01, 1) == 0);
    CHECK(at(-2, 0.5, 0) == 0);
    CHECK(at(-4.5, 0.01, 0) == 0);
    CHECK(at(2 / 1.1, 2, 2) == 255);  // a metre farther away
    CHECK(at(2 / 1.1, 2, 1) == Approx(128).margin(2));
    int lit = 0;
    for (std::size_t row = 0; row < kSize; ++row) lit += rgb[3 * (row * kSize + 16)] > 100 ? 1 : 0;
    CHECK(lit >= 3);
    CHECK(lit <= 4);
}
