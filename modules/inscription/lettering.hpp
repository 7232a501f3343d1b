#pragma once

#include <cstddef>
#include <optional>

#include "legibility.hpp"
#include "orbweaver/contracts/inscriber.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

/// Where a target is to lie on a web.
struct WhereToWrite {
    std::optional<Spot> position;  ///< m right of and above the hub, of the target's middle
    std::optional<double> size;    ///< m, the target's width
    bool best_place = false;       ///< where neither is said: where words become largest, beside the hub
    double most_ink = 0;       ///< in best_place: silk in letters as they were before, over the web's, at most
    std::size_t lines = 1;     ///< of text, among which the hub may come to lie
    std::uint32_t side = 600;  ///< pixels of the page (the thesis's)
    double blur = 1;           ///< meshes, standard deviation
};

/// The target as it lies on a web at rest: as large as the page and in its middle unless said otherwise. Throws
/// Fault(invalid) for a web without a spiral, for a target of which nothing is dark on the page, and for words
/// that find no place at which they are three meshes high.
Lettering lay_on(const WebAtRest& web, const Target& target, const WhereToWrite& where);

}  // namespace orbweaver::inscription
