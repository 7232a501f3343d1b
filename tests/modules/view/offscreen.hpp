#pragma once

#include <GL/osmesa.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "gl.hpp"

namespace orbweaver::test {

/// A canvas without a module around it, for tests of passes.
class Offscreen final : public Canvas {
public:
    Offscreen(int width, int height) {
        std::string why;
        REQUIRE(open(width, height, "test", why));
        gl = view::load_gl(*this);
    }
    Offscreen(const Offscreen&) = delete;
    Offscreen& operator=(const Offscreen&) = delete;
    ~Offscreen() { OSMesaDestroyContext(context_); }

    bool open(int width, int height, const char*, std::string&) noexcept override {
        const int attributes[] = {OSMESA_FORMAT,
                                  OSMESA_RGBA,
                                  OSMESA_PROFILE,
                                  OSMESA_CORE_PROFILE,
                                  OSMESA_CONTEXT_MAJOR_VERSION,
                                  3,
                                  OSMESA_CONTEXT_MINOR_VERSION,
                                  3,
                                  0};
        width_ = width;
        height_ = height;
        pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        context_ = OSMesaCreateContextAttribs(attributes, nullptr);
        return context_ != nullptr &&
               OSMesaMakeCurrent(context_, pixels.data(), GL_UNSIGNED_BYTE, width, height) == GL_TRUE;
    }
    int width() const noexcept override { return width_; }
    int height() const noexcept override { return height_; }
    void* gl_function(const char* name) const noexcept override {
        return name == hidden ? nullptr : reinterpret_cast<void*>(OSMesaGetProcAddress(name));
    }
    void present() noexcept override {}

    view::Gl gl;
    std::string hidden;                // a function to be found missing
    std::vector<std::uint8_t> pixels;  // framebuffer 0: RGBA, rows from the bottom

private:
    int width_ = 0;
    int height_ = 0;
    OSMesaContext context_ = nullptr;
};

}  // namespace orbweaver::test
