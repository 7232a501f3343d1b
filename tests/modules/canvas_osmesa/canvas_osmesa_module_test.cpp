#include <GL/glcorearb.h>

#include <catch2/catch.hpp>
#include <string>

#include "fake_host.hpp"
#include "orbweaver/contracts/canvas.hpp"

using namespace orbweaver;

TEST_CASE("the off-screen canvas offers at least OpenGL 3.3 and its functions by name", "[image]") {
    test::FakeHost host;
    test::LoadedModule module("canvas_osmesa");
    REQUIRE(module.attach(host));
    auto* canvas = host.find<Canvas>();
    REQUIRE(canvas != nullptr);
    std::string why;
    REQUIRE(canvas->open(64, 48, "test", why));
    CHECK(canvas->width() == 64);
    CHECK(canvas->height() == 48);
    const auto get = reinterpret_cast<PFNGLGETINTEGERVPROC>(canvas->gl_function("glGetIntegerv"));
    REQUIRE(get != nullptr);
    GLint major = 0;
    GLint minor = 0;
    get(GL_MAJOR_VERSION, &major);
    get(GL_MINOR_VERSION, &minor);
    CHECK(10 * major + minor >= 33);
}

TEST_CASE("a canvas beyond all sizes is refused in a sentence", "[extreme]") {
    test::FakeHost host;
    test::LoadedModule module("canvas_osmesa");
    REQUIRE(module.attach(host));
    std::string why;
    CHECK_FALSE(host.find<Canvas>()->open(100000, 20000, "test", why));
    CHECK(why.find("ask for a smaller --size") != std::string::npos);
}
