#include "prestress.hpp"

namespace orbweaver::web {

namespace {

const StrandRule& rule_of(Kind kind, const Construction& how) {
    switch (kind) {
        case Kind::anchor:
            return how.outer_frame;
        case Kind::frame:
            return how.inner_frame;
        default:
            return how.spokes;
    }
}

}  // namespace

mass_spring::Network over_extend(const Layout& layout, const Construction& how, double particle_mass,
                                 double damping) {
    mass_spring::Network network;
    network.mass.assign(layout.positions.size(), particle_mass);
    network.fixed = layout.fixed;
    for (const Piece& piece : layout.pieces) {
        const StrandRule& rule = rule_of(piece.kind, how);
        const double length = distance(layout.positions[piece.a], layout.positions[piece.b]);
        network.springs.push_back({piece.a, piece.b, length * rule.rest_length / rule.placement,
                                   rule.stiffness * rule.placement / length, damping});
    }
    return network;
}

}  // namespace orbweaver::web
