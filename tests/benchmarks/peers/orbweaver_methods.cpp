#include <cmath>

#include "adviser.hpp"
#include "contender.hpp"
#include "integrator.hpp"
#include "stopwatch.hpp"

namespace orbweaver::peers {
namespace {

using namespace mass_spring;

Run equal_steps(const Problem& problem, const MethodInfo& method, double step) {
    SpringSystem system(problem.network, nullptr);
    system.set_surroundings(problem.surroundings());
    Integrator integrator(system, method);
    Run run{problem.x, 0};
    std::vector<Vec3> v = problem.v;
    const double count = std::ceil(problem.duration / step);
    const Stopwatch watch;
    integrator.advance(run.x, v, problem.duration / count, static_cast<std::int64_t>(count));
    run.seconds = watch.seconds();
    return run;
}

Run within_tolerance(const Problem& problem, const MethodInfo& method, double tolerance) {
    constexpr double kFirstStep = 1e-5;  // s
    constexpr std::int64_t kMostSteps = 10'000'000;
    SpringSystem system(problem.network, nullptr);
    system.set_surroundings(problem.surroundings());
    Integrator integrator(system, method);
    Run run{problem.x, 0};
    std::vector<Vec3> v = problem.v;
    const Stopwatch watch;
    const bool finished =
        integrator.advance_within(run.x, v, problem.duration, tolerance, kFirstStep, kMostSteps).finished;
    run.seconds = watch.seconds();
    if (!finished) run.x.clear();
    return run;
}

/// The longest step worth trying.
double first_step(const Problem& problem, const MethodInfo& method) {
    constexpr double kFrame = 1.0 / 60;  // s
    SpringSystem system(problem.network, nullptr);
    system.set_surroundings(problem.surroundings());
    return std::min(kFrame, advise(system, problem.x, method).stable_step);
}

}  // namespace

double step_ratio(int order) { return std::pow(1.6, -1.0 / order); }

Contenders orbweaver_methods(const Problem& problem) {
    Contenders all;
    for (const MethodInfo& method : methods()) {
        if (method.undamped && is_damped(problem.network)) continue;
        const std::string name = "orbweaver " + std::string(method.name);
        const double first = first_step(problem, method);
        if (first > 0)
            all.push_back({name, "orbweaver's", "step", first, step_ratio(method.order),
                           [&](double step) { return equal_steps(problem, method, step); }, true});
        if (method.embedded_order > 0)
            all.push_back({name, "orbweaver's", "tolerance", 1e-4, kToleranceRatio,
                           [&](double tolerance) { return within_tolerance(problem, method, tolerance); },
                           true});
    }
    return all;
}

}  // namespace orbweaver::peers
