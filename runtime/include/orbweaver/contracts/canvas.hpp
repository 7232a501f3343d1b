#pragma once

#include <string>

namespace orbweaver {

/// Something that OpenGL 3.3 core can draw on. Framebuffer 0 is what present() shows.
class Canvas {
public:
    static constexpr const char* kContract = "canvas/1";

    /// Makes the drawing area and its context, and makes that current on the calling thread.
    /// Throws nothing: false, and `why` is a sentence.
    virtual bool open(int width, int height, const char* title, std::string& why) noexcept = 0;
    virtual int width() const noexcept = 0;  ///< pixels, as they are now (a window may be resized)
    virtual int height() const noexcept = 0;
    /// The address of a GL function, or null. Never libGL's own: whatever the canvas draws with.
    virtual void* gl_function(const char* name) const noexcept = 0;
    virtual void present() noexcept = 0;

protected:
    ~Canvas() = default;
};

}  // namespace orbweaver
