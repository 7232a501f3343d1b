#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A straight piece of thread between two points.
struct ThreadSegment {
    std::uint32_t a = 0;
    std::uint32_t b = 0;
    std::uint32_t kind = 0;  ///< index into Threads::kinds()
    float width = 1;         ///< times as much silk as others of its kind
};

/// Threads to be seen, and later to be stood on.
class Threads {
public:
    static constexpr const char* kContract = "threads/1";

    virtual std::span<const Vec3> points() const noexcept = 0;  ///< m; may move every frame
    virtual std::span<const ThreadSegment> segments() const noexcept = 0;
    virtual std::span<const std::string_view> kinds() const noexcept = 0;  ///< "anchor", "radius", ...
    /// Changes whenever segments() does.
    virtual std::uint64_t revision() const noexcept = 0;

protected:
    ~Threads() = default;
};

}  // namespace orbweaver
