#include "window.hpp"

#include <cstdlib>
#include <string_view>

namespace orbweaver::canvas_sdl {
namespace {

/// Without a display SDL falls back to drivers whose windows nobody sees; only who names one wants it.
bool anyone_can_see() {
    if (std::getenv("SDL_VIDEODRIVER") != nullptr) return true;
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    return driver != "offscreen" && driver != "dummy";
}

std::string sdl_says() { return std::string("SDL says: ") + SDL_GetError(); }

void ask_for_core_profile() {
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_CORE);
    SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);
}

}  // namespace

Window::~Window() {
    if (context_ != nullptr) SDL_GL_DeleteContext(context_);
    window_.reset();
    if (video_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

bool Window::open(int width, int height, const char* title, std::string& why) {
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    video_ = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
    if (video_ && !anyone_can_see()) {
        why =
            "There is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY leads to one); use "
            "--headless.";
        return false;
    }
    if (!video_) {
        why = "There is no display to open a window on (" + sdl_says() + "); use --headless.";
        return false;
    }
    ask_for_core_profile();
    window_.reset(SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                                   SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    if (!window_) {
        why = "The display opens no window for OpenGL (" + sdl_says() + "); use --headless.";
        return false;
    }
    context_ = SDL_GL_CreateContext(window_.get());
    if (context_ == nullptr) {
        why = "The display offers no OpenGL 3.3 core (" + sdl_says() + "); use --headless.";
        return false;
    }
    SDL_GL_SetSwapInterval(1);
    return true;
}

void Window::drawable_size(int& width, int& height) const noexcept {
    SDL_GL_GetDrawableSize(window_.get(), &width, &height);
}

void Window::mouse_size(int& width, int& height) const noexcept {
    SDL_GetWindowSize(window_.get(), &width, &height);
}

}  // namespace orbweaver::canvas_sdl
