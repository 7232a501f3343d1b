#pragma once

#include <algorithm>
#include <cmath>

#include "score.hpp"

namespace orbweaver::test {

/// The score as its definition says: every pixel of the picture is asked whether its middle is within 2.5
/// pixels of the line, and projected between its ends.
inline int plain_score(const inscription::Bitmap& source, const inscription::Bitmap& target,
                       const inscription::Spot& a, const inscription::Spot& b) {
    const double wx = b.x - a.x, wy = b.y - a.y, square = wx * wx + wy * wy;
    unsigned in_source = 0, in_target = 0;
    for (std::uint32_t y = 0; y < source.height; ++y)
        for (std::uint32_t x = 0; x < source.width; ++x) {
            const double px = x + 0.5, py = y + 0.5;
            const double share = ((px - a.x) * wx + (py - a.y) * wy) / square;
            const double foot_x = a.x + share * wx, foot_y = a.y + share * wy;
            if (!(share >= 0 && share <= 1 && std::hypot(px - foot_x, py - foot_y) <= 2.5)) continue;
            in_source += source.row(y)[x];
            in_target += target.row(y)[x];
        }
    if (in_source == 0) return 1;
    int score = 10;
    while (score > 1 && static_cast<unsigned>(score) * in_source > 10 * in_target) --score;
    return score;
}

}  // namespace orbweaver::test
