#pragma once

#include <vector>

#include "mass_spring/linear_solver.hpp"
#include "mass_spring/settle.hpp"
#include "mass_spring/spring_system.hpp"
#include "orbweaver/contracts/inscriber.hpp"
#include "web.hpp"

namespace orbweaver::web {

/// What webs come to rest by.
struct Settling {
    Vec3 gravity;  ///< m/s^2
    mass_spring::LinearSolverKind linear_solver;
    Workers* workers = nullptr;  ///< null: one thread
};

/// Brings the web's layout to rest.
mass_spring::Settlement settle(Web& web, const Settling& how);

/// The threads of a web for whoever is to see them.
std::vector<ThreadSegment> segments_of(const Layout& layout);

/// A web that can be tried in other forms: each is built from the plain one, and brought to rest.
class Draft final : public WebDraft {
public:
    /// Brings the web to rest. Throws Fault(invalid) where it does not come to rest.
    Draft(Web web, const Settling& how);

    const WebAtRest& plain() const noexcept override { return plain_.seen; }
    const WebAtRest& changed(const WebChange& change) override;
    /// The web as it was changed last, or the plain one.
    const Web& web() const noexcept { return is_changed_ ? changed_.web : plain_.web; }

private:
    struct Form {
        Web web;
        std::vector<ThreadSegment> segments;
        std::vector<double> tension;  ///< N
        WebAtRest seen;
    };
    void bring_to_rest(Form& form) const;

    Settling how_;
    Form plain_, changed_;
    bool is_changed_ = false;
};

}  // namespace orbweaver::web
