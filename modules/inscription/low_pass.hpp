#pragma once

#include "raster.hpp"

namespace orbweaver::inscription {

/// A Gaussian blur of standard deviation `sigma` pixels, above 0; what lies beyond an edge is as the edge is.
Shades low_pass(const Shades& shades, double sigma);

}  // namespace orbweaver::inscription
