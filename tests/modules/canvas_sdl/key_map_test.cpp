#include "key_map.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string>

using namespace orbweaver;
using namespace orbweaver::canvas_sdl;

namespace {

SDL_Event press(SDL_Keycode key, bool repeated = false) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = key;
    event.key.repeat = repeated ? 1 : 0;
    return event;
}

}  // namespace

TEST_CASE("each key does what the list of keys says", "[unit]") {
    InputEvents events;
    for (const auto key : {SDLK_ESCAPE, SDLK_SPACE, SDLK_PERIOD, SDLK_PERIOD, SDLK_r, SDLK_c, SDLK_F1})
        translate(press(key), {}, events);
    CHECK(events.quit);
    CHECK(events.toggle_pause);
    CHECK(events.steps == 2);
    CHECK(events.reset);
    CHECK(events.reset_camera);
    CHECK(events.help);
    for (const char* word : {"space", ".", "R ", "C ", "arrows", "wheel", "F1", "Esc"})
        CHECK(std::string(key_list()).find(word) != std::string::npos);
}

TEST_CASE("keys that are held lead a creature, and opposite ones cancel", "[unit]") {
    std::array<Uint8, SDL_NUM_SCANCODES> held{};
    const auto after = [&](std::initializer_list<SDL_Scancode> keys) {
        held.fill(0);
        for (const SDL_Scancode key : keys) held[key] = 1;
        InputEvents events;
        translate_held(held.data(), events);
        return std::array{events.walk, events.turn};
    };
    CHECK(after({}) == std::array{0, 0});
    CHECK(after({SDL_SCANCODE_W, SDL_SCANCODE_A}) == std::array{1, 1});
    CHECK(after({SDL_SCANCODE_S, SDL_SCANCODE_D}) == std::array{-1, -1});
    CHECK(after({SDL_SCANCODE_W, SDL_SCANCODE_S, SDL_SCANCODE_D}) == std::array{0, -1});
}

TEST_CASE("pausing twice within a picture is no pause, holding the key is one", "[unit]") {
    InputEvents events;
    translate(press(SDLK_SPACE), {}, events);
    translate(press(SDLK_SPACE, true), {}, events);
    CHECK(events.toggle_pause);
    translate(press(SDLK_SPACE), {}, events);
    CHECK_FALSE(events.toggle_pause);
}

TEST_CASE("a drag is measured in fractions of the window, up positive", "[unit]") {
    SDL_Event event{};
    event.type = SDL_MOUSEMOTION;
    event.motion.state = SDL_BUTTON_LMASK;
    event.motion.xrel = 64;
    event.motion.yrel = 36;
    InputEvents events;
    translate(event, {640, 360}, events);
    CHECK(events.orbit_x == Approx(0.1));
    CHECK(events.orbit_y == Approx(-0.1));
    event.motion.state = 0;
    translate(event, {640, 360}, events);
    CHECK(events.orbit_x == Approx(0.1));
}
