#include "draft.hpp"

#include <fmt/format.h>

#include "alteration.hpp"
#include "measures.hpp"
#include "orbweaver/fault.hpp"

namespace orbweaver::web {

mass_spring::Settlement settle(Web& web, const Settling& how) {
    mass_spring::SpringSystem system(web.network, how.workers);
    system.set_surroundings({how.gravity, 0, {}});
    system.use_linear_solver(how.linear_solver);
    return mass_spring::settle(system, web.layout.positions);
}

std::vector<ThreadSegment> segments_of(const Layout& layout) {
    std::vector<ThreadSegment> segments;
    segments.reserve(layout.pieces.size());
    for (const Piece& piece : layout.pieces)
        segments.push_back(
            {piece.a, piece.b, static_cast<std::uint32_t>(piece.kind), static_cast<float>(piece.width)});
    return segments;
}

Draft::Draft(Web web, const Settling& how) : how_(how) {
    plain_.web = std::move(web);
    bring_to_rest(plain_);
}

const WebAtRest& Draft::changed(const WebChange& change) {
    changed_.web = alter(plain_.web, change);
    bring_to_rest(changed_);
    is_changed_ = true;
    return changed_.seen;
}

void Draft::bring_to_rest(Form& form) const {
    const mass_spring::Settlement found = settle(form.web, how_);
    if (!found.converged)
        throw Fault(
            FaultKind::invalid,
            fmt::format("a web that is to be written in does not come to rest: after {} iterations {:.3g} "
                        "N are left of the {:.3g} N sought; make it tauter, or write less in it",
                        found.iterations, found.residual, found.tolerance));
    const Layout& layout = form.web.layout;
    form.segments = segments_of(layout);
    form.tension.clear();
    for (const mass_spring::Spring& spring : form.web.network.springs)
        form.tension.push_back(mass_spring::tension(spring, layout.positions));
    form.seen = {layout.positions, form.segments,
                 form.tension,     kKindNames,
                 layout.center,    layout.plane.across,
                 layout.plane.up,  measure_orb(layout, layout.positions).mesh_width,
                 found.residual};
}

}  // namespace orbweaver::web
