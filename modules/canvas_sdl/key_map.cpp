#include "key_map.hpp"

namespace orbweaver::canvas_sdl {
namespace {

constexpr double kArrowTurn = 0.03;  // of the window a press, or a repeat while held

void translate_key(const SDL_KeyboardEvent& key, InputEvents& events) noexcept {
    const bool first = key.repeat == 0;
    switch (key.keysym.sym) {
        case SDLK_ESCAPE:
            events.quit = true;
            break;
        case SDLK_SPACE:
            events.toggle_pause ^= first;
            break;
        case SDLK_PERIOD:
            events.steps += 1;
            break;
        case SDLK_r:
            events.reset = true;
            break;
        case SDLK_c:
            events.reset_camera = true;
            break;
        case SDLK_h:
        case SDLK_F1:
            events.help |= first;
            break;
        case SDLK_LEFT:
            events.orbit_x -= kArrowTurn;
            break;
        case SDLK_RIGHT:
            events.orbit_x += kArrowTurn;
            break;
        case SDLK_UP:
            events.orbit_y += kArrowTurn;
            break;
        case SDLK_DOWN:
            events.orbit_y -= kArrowTurn;
            break;
        default:
            break;
    }
}

}  // namespace

void translate(const SDL_Event& event, WindowSize window, InputEvents& events) noexcept {
    switch (event.type) {
        case SDL_QUIT:
            events.quit = true;
            break;
        case SDL_KEYDOWN:
            translate_key(event.key, events);
            break;
        case SDL_MOUSEWHEEL:
            events.zoom += event.wheel.preciseY;
            break;
        case SDL_MOUSEMOTION:
            if ((event.motion.state & SDL_BUTTON_LMASK) == 0) break;
            events.orbit_x += static_cast<double>(event.motion.xrel) / window.width;
            events.orbit_y -= static_cast<double>(event.motion.yrel) / window.height;
            break;
        default:
            break;
    }
}

void translate_held(const Uint8* held, InputEvents& events) noexcept {
    const auto between = [&](SDL_Scancode more, SDL_Scancode less) {
        return (held[more] != 0 ? 1 : 0) - (held[less] != 0 ? 1 : 0);
    };
    events.walk = between(SDL_SCANCODE_W, SDL_SCANCODE_S);
    events.turn = between(SDL_SCANCODE_A, SDL_SCANCODE_D);
}

const char* key_list() noexcept {
    return "space          pause, go on\n"
           ".              one frame while paused\n"
           "R              back to the first frame\n"
           "arrows, drag   turn about the middle\n"
           "wheel          nearer, farther\n"
           "W, S, A, D     a creature forward, back, to the left, to the right (keys = true)\n"
           "C              camera back to where it began\n"
           "F1, H          this list\n"
           "Esc            quit\n";
}

}  // namespace orbweaver::canvas_sdl
