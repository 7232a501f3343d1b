#pragma once

#include <array>
#include <span>
#include <vector>

#include "construction.hpp"
#include "layout.hpp"
#include "mass_spring/network.hpp"

namespace orbweaver::web {

/// The thesis's way to a taut web (section 5.1): springs laid longer than their rest length. The rule gives
/// the spring of length l = placement; a piece of another length is as many of those in series:
/// r = l rest_length/placement, k = stiffness placement/l, so a thread's tension k (l - r) does not depend
/// on how it is divided. Hub and spiral are of the spokes' thread, since the thesis names three constants.
mass_spring::Network over_extend(const Layout& layout, const Construction& how, double particle_mass,
                                 double damping);

/// What a sort of thread bears and how it stretches.
struct Silk {
    double tension = 0;          ///< T, N, sought at rest
    double axial_stiffness = 0;  ///< EA, N
    double linear_density = 0;   ///< kg/m; 0: every particle weighs the same
    /// T = EA s (1 - a s + b s^2) at strain s > 0, see mass_spring::MaterialLaw.
    double softening = 0;        ///< a
    double stiffening = 0;       ///< b
    double hysteresis = 0;       ///< stiffness of a Maxwell element beside it, over EA
    double relaxation_time = 0;  ///< s, of that
};

/// Of a spring of that rest length, m.
mass_spring::MaterialLaw law_of(const Silk& silk, double rest_length) noexcept;

/// By Kind.
using Silks = std::array<Silk, kKindNames.size()>;

/// Force densities (Schek 1974): with q = T/l given per piece, the equilibrium of the free particles under
/// their loads p solves, for each coordinate, sum_j q_ij (x_i - x_j) = p_i: one symmetric positive definite
/// system. Returns all positions, m. Throws Fault(invalid) where free particles hang on no fixed one.
std::vector<Vec3> solve_force_densities(const Layout& layout, std::span<const double> densities,
                                        std::span<const Vec3> loads);

/// Moves the layout into equilibrium under gravity (m/s^2) with q = T/l of each piece as laid, and derives the
/// springs that are at rest there: T = q l, r = l/(1 + s) with the strain s at which the silk bears T (T/EA
/// where it has no curve), k = EA/r. No spring is slack. A particle weighs half of each thread it ends, of its
/// length as found without that weight; `particle_mass` (kg) where no silk has a density.
mass_spring::Network find_form(Layout& layout, const Silks& silks, double particle_mass, double damping,
                               const Vec3& gravity);

}  // namespace orbweaver::web
