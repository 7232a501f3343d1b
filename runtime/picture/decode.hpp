#pragma once

#include <cstddef>
#include <string>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/fault.hpp"
#include "picture/picture.hpp"

namespace orbweaver::picture {

/// What a picture may cost at most; a header that asks for more is refused before anything is decoded.
struct Limits {
    std::size_t file_bytes = std::size_t{256} << 20;
    std::size_t pixels = std::size_t{8192} * 4096;
};

/// A picture that cannot be had: invalid, or beyond a limit. `diagnostic().where` names the picture's file; who
/// knows where a scene asked for it may put that place there instead.
class Unreadable : public Fault {
public:
    explicit Unreadable(Diagnostic diagnostic, FaultKind kind = FaultKind::invalid)
        : Fault(kind, to_string(diagnostic)), diagnostic_(std::move(diagnostic)) {}
    const Diagnostic& diagnostic() const noexcept { return diagnostic_; }

private:
    Diagnostic diagnostic_;
};

/// Reads a PNG, JPEG or Radiance HDR file; the last is clamped to [0, 1]. Alpha is dropped.
/// Throws Unreadable.
Picture decode(const std::string& path, const Limits& limits = {});

/// The same file in shades of gray (luma of Rec. 709), as it looks on white paper: alpha lets the paper
/// through. Throws Unreadable.
GrayPicture decode_gray(const std::string& path, const Limits& limits = {});

/// The same file as light. Throws Unreadable.
LinearPicture decode_linear(const std::string& path, const Limits& limits = {});

}  // namespace orbweaver::picture
