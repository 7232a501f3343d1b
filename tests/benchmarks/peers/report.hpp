#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "sweep.hpp"

namespace orbweaver::peers {

/// What both sides do alike, and how many times longer the peer's way takes.
struct Comparison {
    std::string what;
    double ours = 0;   ///< s
    double peers = 0;  ///< s
    double ratio() const noexcept { return peers / ours; }
};

/// Of one problem.
struct Report {
    std::string problem;
    std::size_t particles = 0;
    std::size_t springs = 0;
    double moved = 0;  ///< m, the largest way of a particle
    double doubt = 0;  ///< m, between two references
    std::vector<Comparison> comparisons;
    std::vector<Sweep> sweeps;

    /// Of the cheapest of ours within a target; infinite where there is none.
    double our_seconds(std::size_t target) const;
};

void print(const Report& report, std::ostream& out);
/// Throws std::runtime_error where the file cannot be written.
void write_json(const std::vector<Report>& reports, const std::string& path);

}  // namespace orbweaver::peers
