#pragma once

#include <array>
#include <span>
#include <vector>

#include "gait.hpp"
#include "lattice.hpp"

namespace orbweaver::crawler {

/// Muscles give springs the lengths that they have in a body of another shape: each segment is longer by its
/// strain and bent about its middle, and rings grow and shrink by 1/sqrt(1 + strain), if volume is to stay
/// (Miller 1988).
class Muscles {
public:
    explicit Muscles(const Build& build);

    /// m, in the order of a body's springs (see Lattice).
    void lengths(std::span<const Flex> flexes, std::span<double> rest) noexcept;

private:
    Build build_;
    std::vector<double> edges_;  ///< m, of each ring
};

}  // namespace orbweaver::crawler
