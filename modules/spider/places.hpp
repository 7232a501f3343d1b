#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/random.hpp"

namespace orbweaver::spider {

/// Finds where creatures of a group begin.
class Places {
public:
    /// `apart`: m, that they are to be from each other where there is room.
    Places(const Surface& surface, const Vec3& gravity, double apart, const RandomStream& random);

    /// Where the surface is nearest to `point` (m), on the side of it on which that is; facing along `heading`
    /// as nearly as the surface lets it. It holds on there, or `holds` is false.
    struct Found {
        SurfaceStep place;  ///< its answer is `found`, or there is no surface to stand on
        bool holds = false;
    };
    Found near(const Vec3& point, const Vec3& heading) const noexcept;
    /// Creature `number` of `count` at random in the surface's bounds, on the front of it, where it holds on,
    /// and clear of those that were taken; it faces along `heading`, or at random.
    Found at_random(std::uint64_t number, std::uint64_t count, const std::optional<Vec3>& heading) const;
    /// Somebody stands there.
    void take(const Vec3& position);

private:
    using Cell = std::array<std::int64_t, 3>;
    Cell cell_of(const Vec3& position) const noexcept;
    bool is_clear(const Vec3& position) const;
    Found found(const Vec3& point, const Vec3& heading, bool on_front) const noexcept;

    const Surface& surface_;
    Vec3 gravity_;
    double apart_;
    RandomStream random_;
    Vec3 low_, high_;  // m, the surface's bounds
    std::multimap<Cell, Vec3> taken_;
};

}  // namespace orbweaver::spider
