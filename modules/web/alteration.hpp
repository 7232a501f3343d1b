#pragma once

#include "orbweaver/contracts/inscriber.hpp"
#include "web.hpp"

namespace orbweaver::web {

/// The web (at rest where its layout lies) with that change made, not yet at rest again. Threads that stay keep
/// their order, those that are thickened in part cut in place; then come those added. New particles come last.
///
/// A thread of width w is as taut as without: of tension T = EA s at strain s it has w EA and s/w, which is
/// exact for threads without a curve. Weight follows silk: a particle that weighs m and ends threads of length
/// L in all has m/L of weight for each half of a length, of which threads that come or go add or take theirs.
///
/// Throws Fault(invalid) in words: see WebDraft::changed().
Web alter(const Web& plain, const WebChange& change);

}  // namespace orbweaver::web
