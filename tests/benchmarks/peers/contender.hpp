#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem.hpp"

namespace orbweaver::peers {

/// What a contender made of a problem at one setting.
struct Run {
    std::vector<Vec3> x;  ///< m, at the end; empty where it gave up
    double seconds = 0;   ///< of processor time, without what is set up once
};

/// One way to integrate a problem, with one knob.
struct Contender {
    std::string name;
    std::string right_side;  ///< who evaluates the forces
    std::string knob;        ///< "step" (s) or "tolerance" (the method's own)
    double first = 0;        ///< setting that a sweep begins with
    double ratio = 0;        ///< from one setting to the next, below 1
    std::function<Run(double setting)> run;
    bool ours = false;
};

using Contenders = std::vector<Contender>;

/// The ratio of steps at which errors of a method of that order shrink 1.6 times.
double step_ratio(int order);
/// From one tolerance to the next.
inline constexpr double kToleranceRatio = 0.31622776601683794;  // two to a decade

// One line per file of peers. `problem` must outlive what they return.
Contenders orbweaver_methods(const Problem& problem);
Contenders odeint_methods(const Problem& problem);
Contenders cvode_methods(const Problem& problem);
Contenders bullet_methods(const Problem& problem);

}  // namespace orbweaver::peers
