#pragma once

#include "web.hpp"

namespace orbweaver::web {

/// A single strand (thesis, section 5.1) between two fixed ends.
struct StrandPlan {
    Vec3 from;                ///< m
    Vec3 to;                  ///< m
    double placement = 7e-3;  ///< m, between masses
    double extension = 0;     ///< (l - r)/r as laid: 0 at rest lengths, 0.75 to 2.5 taut, below 0 slack
    double stiffness = 1e-2;  ///< N/m, of a spring as long as the placement
};

/// Reports a fault where the ends coincide or are not finite.
std::optional<Web> lay_single_strand(const StrandPlan& plan, double particle_mass, double damping,
                                     Diagnostics& faults);

}  // namespace orbweaver::web
