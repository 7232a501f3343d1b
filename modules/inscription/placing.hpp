#pragma once

#include <optional>
#include <vector>

#include "box.hpp"
#include "page.hpp"
#include "raster.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

/// Where a block comes to lie on a page.
struct Placement {
    Box block;         ///< of the target
    Spot middle;       ///< of the block, pixels of the page
    double scale = 1;  ///< pixels of the page that a pixel of the target takes
};

/// The whole target, its middle at `middle` and `width` pixels of the page wide.
Placement whole(const Target& target, const Spot& middle, double width);

/// What is dark on a page of side x side pixels where blocks of a target lie as said: each pixel is as the
/// target is at its middle.
Bitmap place(const Target& target, const std::vector<Placement>& placements, std::uint32_t side);

/// Where that block lies on a page, cut at its edges.
Box box_of(const Placement& placed, std::uint32_t side);

/// Pixels of the page that what is dark in the target would take beside the page, there where it is placed.
double dark_beside(const Target& target, const Placement& placed, std::uint32_t side);

/// The blocks of `lines` lines of text, as close as what is dark in them: the upper half of the lines (the
/// larger half), and the others. One block where there is one line, or where no blank rows part them.
std::vector<Box> blocks_of(const Target& target, std::size_t lines);

/// Places one block, or one above and one below the hub's row, as large as fits: the largest scale, the same
/// for both and not above `most`, at which all but 0.5 % of what is dark lies on pixels that are `writable`; of
/// the places where it does, the nearest to the hub's column, and there the deepest inside. Nothing where they
/// do not fit at a scale of `least`.
std::optional<std::vector<Placement>> best_placements(const Target& target, const std::vector<Box>& blocks,
                                                      const Bitmap& writable, const Spot& hub, double least,
                                                      double most);

}  // namespace orbweaver::inscription
