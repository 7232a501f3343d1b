#include "gl.hpp"

#include "offscreen.hpp"
#include "orbweaver/fault.hpp"

using namespace orbweaver;

TEST_CASE("a function that the canvas lacks is named in a sentence", "[extreme]") {
    test::Offscreen canvas(16, 16);
    canvas.hidden = "glTexBuffer";
    CHECK_THROWS_WITH(
        view::load_gl(canvas),
        "The canvas lacks functions of OpenGL 3.3 that the view calls: glTexBuffer; update the graphics "
        "driver, or draw off-screen with --headless.");
}

TEST_CASE("objects move without being deleted twice", "[unit]") {
    const test::Offscreen canvas(16, 16);
    view::Object a(canvas.gl, view::ObjectKind::texture);
    const auto name = a.name();
    view::Object b(std::move(a));
    CHECK(b.name() == name);
    view::Object c;
    c = std::move(b);
    CHECK(c.name() == name);
}
