#include <GL/osmesa.h>

#include <cstdint>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "manifest_text.hpp"
#include "orbweaver/contracts/canvas.hpp"
#include "orbweaver/entry.hpp"

namespace orbweaver::canvas_osmesa {
namespace {

constexpr int kLargestSide = 16384;  // Mesa's software rasterizers go no further

struct ContextDestroy {
    void operator()(OSMesaContext context) const noexcept { OSMesaDestroyContext(context); }
};
using Context = std::unique_ptr<osmesa_context, ContextDestroy>;

Context make_context() {
    constexpr int kAttributes[] = {OSMESA_FORMAT,
                                   OSMESA_RGBA,
                                   OSMESA_DEPTH_BITS,
                                   24,
                                   OSMESA_PROFILE,
                                   OSMESA_CORE_PROFILE,
                                   OSMESA_CONTEXT_MAJOR_VERSION,
                                   3,
                                   OSMESA_CONTEXT_MINOR_VERSION,
                                   3,
                                   0};
    return Context(OSMesaCreateContextAttribs(kAttributes, nullptr));
}

class CanvasOsmesa final : public Module, public Canvas {
public:
    void attach(Host& host) override { host.provide<Canvas>(*this); }
    void run(Phase, const Frame&) override {}
    void report(ModuleReport& report) override { report.memory_bytes = pixels_.capacity(); }

    bool open(int width, int height, const char* title, std::string& why) noexcept override;
    int width() const noexcept override { return width_; }
    int height() const noexcept override { return height_; }
    void* gl_function(const char* name) const noexcept override {
        return reinterpret_cast<void*>(OSMesaGetProcAddress(name));
    }
    void present() noexcept override {}

private:
    int width_ = 0;
    int height_ = 0;
    std::vector<std::uint8_t> pixels_;  // framebuffer 0; must outlive the context
    Context context_;
};

bool CanvasOsmesa::open(int width, int height, const char*, std::string& why) noexcept {
    if (width > kLargestSide || height > kLargestSide) {
        why = "OSMesa draws at most " + std::to_string(kLargestSide) +
              " pixels a side; ask for a smaller --size.";
        return false;
    }
    try {
        pixels_.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    } catch (const std::bad_alloc&) {
        why = "There is not enough memory for a picture this large; ask for a smaller --size.";
        return false;
    }
    width_ = width;
    height_ = height;
    context_ = make_context();
    if (!context_) {
        why = "OSMesa offers no OpenGL 3.3 core context; install Debian's libosmesa6 (Mesa 22 or so).";
        return false;
    }
    if (OSMesaMakeCurrent(context_.get(), pixels_.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE) {
        why = "OSMesa refuses a picture of " + std::to_string(width) + " x " + std::to_string(height) +
              " pixels; ask for a smaller --size.";
        return false;
    }
    return true;
}

}  // namespace
}  // namespace orbweaver::canvas_osmesa

ORBWEAVER_MODULE(orbweaver::canvas_osmesa::CanvasOsmesa)
