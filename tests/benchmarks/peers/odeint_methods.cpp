// Boost.odeint (Boost licence), header only, on std::vector<double> as its documents show.

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

#include "adviser.hpp"
#include "contender.hpp"
#include "right_side.hpp"
#include "stopwatch.hpp"

namespace orbweaver::peers {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::vector<double>;

template <class Integrate>
Run timed(const Problem& problem, MakeRightSide make, const Integrate& integrate) {
    const auto right_side = make(problem);
    State y(right_side->length());
    right_side->pack(problem, y.data());
    const auto system = [&](const State& at, State& rate, double) {
        right_side->evaluate(at.data(), rate.data());
    };
    const Stopwatch watch;
    integrate(system, y);
    Run run{{}, watch.seconds()};
    run.x = right_side->positions(y.data());
    return run;
}

Run rk4(const Problem& problem, MakeRightSide make, double step) {
    return timed(problem, make, [&](const auto& system, State& y) {
        const double count = std::ceil(problem.duration / step);
        odeint::integrate_n_steps(odeint::runge_kutta4<State>(), system, y, 0.0, problem.duration / count,
                                  static_cast<std::size_t>(count));
    });
}

Run dopri5(const Problem& problem, MakeRightSide make, double tolerance) {
    constexpr double kFirstStep = 1e-5;  // s
    return timed(problem, make, [&](const auto& system, State& y) {
        odeint::integrate_adaptive(
            odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(tolerance, tolerance), system, y, 0.0,
            problem.duration, kFirstStep);
    });
}

}  // namespace

Contenders odeint_methods(const Problem& problem) {
    const mass_spring::MethodInfo& same = *mass_spring::find_method("rk4");
    mass_spring::SpringSystem system(problem.network, nullptr);
    system.set_surroundings(problem.surroundings());
    const double stable = mass_spring::advise(system, problem.x, same).stable_step;
    Contenders all;
    for (const MakeRightSide make : kRightSides) {
        const std::string right_side(make(problem)->name());
        all.push_back({"odeint rk4", right_side, "step", stable, step_ratio(same.order),
                       [&problem, make](double step) { return rk4(problem, make, step); }});
        all.push_back({"odeint dopri5", right_side, "tolerance", 1e-2, kToleranceRatio,
                       [&problem, make](double tolerance) { return dopri5(problem, make, tolerance); }});
    }
    return all;
}

}  // namespace orbweaver::peers
