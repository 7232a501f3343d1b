#pragma once

#include <cstdint>

#include "layout.hpp"
#include "orbweaver/random.hpp"
#include "site.hpp"

namespace orbweaver::web {

/// How one sort of strand is laid and sprung (thesis, figures 5.5 and 5.10): masses `placement` apart,
/// joined by springs of that rest length and constant.
struct StrandRule {
    double placement = 0;    ///< m
    double rest_length = 0;  ///< m
    double stiffness = 0;    ///< N/m
};

/// Every parameter of the thesis's construction, sections 5.2 and 5.3, with its values.
struct Construction {
    StrandRule outer_frame{5e-3, 2e-3, 1e-3};
    StrandRule inner_frame{20e-3, 15e-3, 1e-3};
    StrandRule spokes{7e-3, 3e-3, 1e-2};
    double move_outer = 50e-3;        ///< m, MOVE_OUTER: how far inner frame points lie inside their anchors
    double inward_pull = 0.06;        ///< sag of a frame segment over its length
    double hub_radius = 15e-3;        ///< m
    double spiral_start = 0;          ///< m, from the frame
    double spiral_end = 20e-3;        ///< m, from the hub
    std::int64_t spiral_density = 5;  ///< SPIRAL_DENSITY: masses of a spoke that may stay uncovered
    double irregularity = 0;          ///< of the spacing of masses, in [0, 1)
};

/// The stages in the thesis's order; each adds to the layout that the ones before it left.
void lay_frame(const Site& site, const Construction& how, Jitter& jitter, Layout& layout);
void lay_spokes(const Site& site, const Construction& how, Jitter& jitter, Layout& layout);
void lay_spiral(const Construction& how, Layout& layout);

/// All stages. Deterministic in the site, the parameters and the stream.
Layout construct(const Site& site, const Construction& how, const RandomStream& stream);

}  // namespace orbweaver::web
