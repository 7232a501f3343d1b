#pragma once

#include <array>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

struct SketchLine {
    Vec3 a, b;                     ///< m
    std::array<float, 3> color{};  ///< sRGB, [0, 1]
};

/// What a module believes, as lines over the picture: for who looks for mistakes, and what nobody else draws.
class Sketch {
public:
    static constexpr const char* kContract = "sketch/1";

    /// Whether there is anything to be drawn, as where somebody asked for it: does not change.
    virtual bool wanted() const noexcept = 0;
    /// As things are now; asked for once a picture.
    virtual std::span<const SketchLine> lines() = 0;

protected:
    ~Sketch() = default;
};

}  // namespace orbweaver
