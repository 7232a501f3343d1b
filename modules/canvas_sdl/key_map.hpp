#pragma once

#include <SDL.h>

#include "orbweaver/contracts/input.hpp"

namespace orbweaver::canvas_sdl {

/// The window's size in the units of its mouse events.
struct WindowSize {
    int width = 1;
    int height = 1;
};

/// Adds what one event means to `events`.
void translate(const SDL_Event& event, WindowSize window, InputEvents& events) noexcept;

/// Adds what keys that are held mean; `held` has an element a scancode, not 0 where its key is down.
void translate_held(const Uint8* held, InputEvents& events) noexcept;

/// The list of keys, one a line.
const char* key_list() noexcept;

}  // namespace orbweaver::canvas_sdl
