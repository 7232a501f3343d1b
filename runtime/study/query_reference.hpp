#pragma once

#include <optional>
#include <vector>

#include "orbweaver/contracts/surface.hpp"

namespace orbweaver::study {

/// What may be answered to a question: `places` that count as the ray's first crossing. Where a ray meets
/// nothing but a rim, rounding decides whether it passes: then not `certain`, and to find nothing is right too.
struct QueryTruth {
    std::vector<Vec3> places;  ///< m; empty: there is nothing to find
    bool certain = false;
};

/// Answers by asking every triangle, in extended precision: knows nothing of trees, neighbours or walks. Around
/// an edge the faces on both sides are held against the same number, so that no ray slips through between them.
class QueryReference {
public:
    /// Reads `surface` for as long as it lives.
    explicit QueryReference(const Surface& surface) : surface_(surface) {}

    /// The first crossing of the question's ray.
    QueryTruth crossing(const Stance& question) const;
    /// The point nearest to the question's position, if within its reach.
    QueryTruth nearest(const Stance& question) const;

private:
    const Surface& surface_;
};

}  // namespace orbweaver::study
