#pragma once

#include <cstdint>
#include <vector>

#include "network.hpp"

namespace orbweaver::mass_spring {

/// A number for each particle, so that springs come in runs (see SpringTable) however the network numbers them:
/// along a thread, straight on where springs cross, and then along what lies beside it, again and again, as the
/// next radius of a web lies beside one, or the next row of a net. Of the springs alone; no coordinate is
/// needed.
std::vector<std::uint32_t> number_along_threads(const Network& network);

}  // namespace orbweaver::mass_spring
