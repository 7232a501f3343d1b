#pragma once

#include "orbweaver/gaussian_blur.hpp"
#include "raster.hpp"

namespace orbweaver::inscription {

/// A Gaussian blur of standard deviation `sigma` pixels, above 0; what lies beyond an edge is as the edge is.
inline Shades low_pass(Shades shades, double sigma) {
    gaussian_blur(shades.values, shades.width, shades.height, sigma);
    return shades;
}

}  // namespace orbweaver::inscription
