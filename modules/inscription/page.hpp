#pragma once

#include <cstdint>

#include "orbweaver/contracts/inscriber.hpp"

namespace orbweaver::inscription {

/// A point of a page, pixels from its upper left corner: x to the right, y down.
struct Spot {
    double x = 0;
    double y = 0;
};

/// A square of a web's plane as a viewer sees it, cut into pixels.
struct Page {
    Vec3 middle;             ///< m
    Vec3 right, up;          ///< unit
    double pixel = 0;        ///< m, a pixel's side
    std::uint32_t side = 0;  ///< pixels

    /// Where a point is seen, along the page's normal; outside of 0 to `side` for what the page does not show.
    Spot spot(const Vec3& point) const noexcept;
    /// m, what is seen in the middle of the page's plane at that spot.
    Vec3 point(const Spot& spot) const noexcept;
};

/// The smallest square that shows all points of a web, `side` pixels wide and high.
Page page_of(const WebAtRest& web, std::uint32_t side);

}  // namespace orbweaver::inscription
