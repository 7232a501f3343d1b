#include <algorithm>
#include <string>

#include "key_map.hpp"
#include "manifest_text.hpp"
#include "orbweaver/contracts/canvas.hpp"
#include "orbweaver/entry.hpp"
#include "window.hpp"

namespace orbweaver::canvas_sdl {
namespace {

class CanvasSdl final : public Module, public Canvas, public Input {
public:
    void attach(Host& host) override {
        host.provide<Canvas>(*this);
        host.provide<Input>(*this);
    }
    void run(Phase, const Frame&) override {}

    bool open(int width, int height, const char* title, std::string& why) noexcept override;
    int width() const noexcept override { return width_; }
    int height() const noexcept override { return height_; }
    void* gl_function(const char* name) const noexcept override { return SDL_GL_GetProcAddress(name); }
    void present() noexcept override { window_.swap(); }

    const InputEvents& poll() noexcept override;
    const InputEvents& latest() const noexcept override { return events_; }
    const char* key_list() const noexcept override { return canvas_sdl::key_list(); }

private:
    Window window_;
    bool open_ = false;
    int width_ = 0;  // pixels
    int height_ = 0;
    InputEvents events_;
};

bool CanvasSdl::open(int width, int height, const char* title, std::string& why) noexcept {
    open_ = window_.open(width, height, title, why);
    if (open_) window_.drawable_size(width_, height_);
    return open_;
}

const InputEvents& CanvasSdl::poll() noexcept {
    events_ = {};
    if (!open_) return events_;
    WindowSize mouse;
    window_.mouse_size(mouse.width, mouse.height);
    mouse = {std::max(mouse.width, 1), std::max(mouse.height, 1)};
    SDL_Event event;
    while (SDL_PollEvent(&event) != 0) translate(event, mouse, events_);
    translate_held(SDL_GetKeyboardState(nullptr), events_);
    window_.drawable_size(width_, height_);
    return events_;
}

}  // namespace
}  // namespace orbweaver::canvas_sdl

ORBWEAVER_MODULE(orbweaver::canvas_sdl::CanvasSdl)
