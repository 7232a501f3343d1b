#pragma once

#include <span>
#include <string_view>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// A group of creatures that others may hunt, flee or keep clear of.
class Creatures {
public:
    static constexpr const char* kContract = "creatures/1";

    /// By which scenes call the group.
    virtual std::string_view name() const noexcept = 0;
    virtual std::span<const Vec3> positions() const noexcept = 0;   ///< m, as of their last frame
    virtual std::span<const Vec3> velocities() const noexcept = 0;  ///< m/s

protected:
    ~Creatures() = default;
};

}  // namespace orbweaver
