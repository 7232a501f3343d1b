#include "window.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>

using orbweaver::canvas_sdl::Window;

TEST_CASE("without a display the sentence says so and names the way out", "[extreme]") {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) unsetenv(name);
    Window window;
    std::string why;
    REQUIRE_FALSE(window.open(320, 200, "test", why));
    CHECK(why.find("There is no display to open a window on") == 0);
    CHECK(why.find("use --headless") != std::string::npos);
}
