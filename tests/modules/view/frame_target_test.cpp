#include "frame_target.hpp"

#include "offscreen.hpp"
#include "orbweaver/fault.hpp"
#include "picture/color.hpp"
#include "sky_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

/// A sky with light `up` above the horizon and `down` below.
CubeSky halves(float up, float down) {
    CubeSky sky;
    sky.size = 16;
    for (std::size_t f = 0; f < kFaces; ++f) {
        for (std::size_t i = 0; i < 256; ++i) {
            const bool above = f == 2 || (f != 3 && i < 128);
            sky.faces[f].insert(sky.faces[f].end(), 3, above ? up : down);
        }
    }
    return sky;
}

}  // namespace

TEST_CASE("a picture is read from its top row, in sRGB, and shown with the same shades", "[image]") {
    test::Offscreen canvas(24, 18);
    FrameTarget target(canvas.gl, 24, 18);
    const SkyPass sky(canvas.gl, halves(0.5F, 0.02F));
    target.bind();
    sky.draw({{0, 0, 1}, {0, 0, 0}, 60}, 24.0 / 18);
    std::vector<std::uint8_t> rgb;
    target.read(rgb);
    REQUIRE(rgb.size() == 24 * 18 * 3);
    CHECK(std::abs(rgb.front() - picture::byte_from_linear(0.5F)) <= 1);
    CHECK(std::abs(rgb.back() - picture::byte_from_linear(0.02F)) <= 1);

    target.copy_to(0, 24, 18);
    GLint pixel = 0;
    canvas.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    canvas.gl.ReadPixels(0, 17, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    CHECK((pixel & 0xff) == rgb.front());
}

TEST_CASE("a picture beyond the driver's size is a limit, said in a sentence", "[extreme]") {
    const test::Offscreen canvas(16, 16);
    try {
        const FrameTarget target(canvas.gl, 1 << 20, 16);
        FAIL("accepted");
    } catch (const Fault& e) {
        CHECK(e.kind() == FaultKind::limit);
        CHECK(std::string(e.what()).find("A picture of 1048576 x 16 pixels is larger than") == 0);
    }
}
