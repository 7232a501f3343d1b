#include "problem.hpp"

#include <algorithm>
#include <limits>

#include "../../modules/web/sample_webs.hpp"
#include "orbweaver/fault.hpp"
#include "settle.hpp"

namespace orbweaver::peers {

Problem web_in_wind(double spring_damping) {
    const Vec3 kWind{0.03e-6, 0, -0.098e-6};
    Problem problem;
    web::Layout layout = web::test::thesis_layout();
    problem.network =
        web::find_form(layout, web::test::default_silks(), web::test::kMass, spring_damping, problem.gravity);
    problem.x = layout.positions;
    problem.v.resize(problem.x.size());
    mass_spring::SpringSystem system(problem.network, nullptr);
    system.set_surroundings({problem.gravity, problem.drag, {}});
    if (!mass_spring::settle(system, problem.x).converged)
        throw Fault(FaultKind::diverged, "the web of the benchmark did not settle to 1e-12 N");
    problem.wind.assign(problem.x.size(), kWind);
    return problem;
}

double largest_error(const std::vector<Vec3>& x, const std::vector<Vec3>& exact) {
    double largest = x.empty() ? std::numeric_limits<double>::infinity() : 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (!is_finite(x[i])) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, distance(x[i], exact[i]));
    }
    return largest;
}

}  // namespace orbweaver::peers
