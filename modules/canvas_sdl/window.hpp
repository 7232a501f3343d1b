#pragma once

#include <SDL.h>

#include <memory>
#include <string>

namespace orbweaver::canvas_sdl {

/// A window with an OpenGL 3.3 core context. Owns SDL's video while it lives.
class Window {
public:
    Window() = default;
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    /// False, and `why` is a sentence.
    bool open(int width, int height, const char* title, std::string& why);
    void swap() noexcept { SDL_GL_SwapWindow(window_.get()); }
    void drawable_size(int& width, int& height) const noexcept;
    void mouse_size(int& width, int& height) const noexcept;

private:
    struct WindowDestroy {
        void operator()(SDL_Window* window) const noexcept { SDL_DestroyWindow(window); }
    };
    bool video_ = false;
    std::unique_ptr<SDL_Window, WindowDestroy> window_;
    SDL_GLContext context_ = nullptr;
};

}  // namespace orbweaver::canvas_sdl
