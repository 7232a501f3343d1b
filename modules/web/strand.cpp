#include "strand.hpp"

#include <fmt/format.h>

#include "prestress.hpp"

namespace orbweaver::web {

std::optional<Web> lay_single_strand(const StrandPlan& plan, double particle_mass, double damping,
                                     Diagnostics& faults) {
    const double length = distance(plan.from, plan.to);
    if (!(length > 0) || !std::isfinite(length)) {
        faults.push_back({{},
                          fmt::format("the strand's ends are {:.6g} m apart", length),
                          "two different places",
                          "move strand.from or strand.to"});
        return std::nullopt;
    }
    Web web;
    Layout& layout = web.layout;
    const Index from = add_particle(layout, plan.from, true);
    const Index to = add_particle(layout, plan.to, true);
    Jitter even(RandomStream(0, ""), 0);
    lay_strand(layout, from, to, Kind::strand, plan.placement, 1, even);
    layout.center = (plan.from + plan.to) / 2;
    Construction how;
    how.spokes = {plan.placement, plan.placement / (1 + plan.extension), plan.stiffness};
    web.network = over_extend(layout, how, particle_mass, damping);
    return web;
}

}  // namespace orbweaver::web
