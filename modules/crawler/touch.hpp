#pragma once

#include "orbweaver/vec3.hpp"

namespace orbweaver::crawler {

/// Where a point is with regard to a ground.
struct Touch {
    double depth = 0;  ///< m below the surface; below 0: above it
    Vec3 normal;       ///< unit, away from it, where depth > 0
    double grip = 1;   ///< by which coefficients of friction are multiplied
};

}  // namespace orbweaver::crawler
