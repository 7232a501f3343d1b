#pragma once

#include <string>
#include <vector>

#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/contracts/threads.hpp"
#include "orbweaver/module.hpp"

namespace orbweaver::surface {

/// Straight lines along a surface, as a scene asks to see them ([surface.line.NAME]): what step() walks, drawn
/// as threads just above it.
class ShownLines final : public Threads {
public:
    /// Reports what the scene gets wrong of them.
    void draw(const Surface& surface, Host& host);

    std::span<const Vec3> points() const noexcept override { return points_; }
    std::span<const ThreadSegment> segments() const noexcept override { return segments_; }
    std::span<const std::string_view> kinds() const noexcept override;
    std::uint64_t revision() const noexcept override { return 0; }

private:
    void walk(const Surface& surface, Footing at, double length);

    std::vector<Vec3> points_;
    std::vector<ThreadSegment> segments_;
};

}  // namespace orbweaver::surface
