#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "plan/option_spec.hpp"

namespace orbweaver {

/// A manifest's [study]: by which of its options a study varies the method of integration and its accuracy. A
/// module that has one keeps the array "position" (m) in its state, reports the measure stable_step_s
/// (infinite, or absent, when every step is stable) and obeys steps that divide the frame.
struct StudySpec {
    std::string method;                   ///< option, a choice: the method of integration
    std::string step;                     ///< option, s: the step of `steps`
    std::string tolerance;                ///< option, m: the tolerance of `tolerances`; empty: there are none
    std::string on_unstable;              ///< option, a choice that has "as_asked" and "substep"
    std::string axis;                     ///< option, a number: what a map of stability varies beside the step
    std::vector<std::string> numerics;    ///< other options of how it is integrated, and not of what
    std::vector<std::string> automatic;   ///< options that are refused beside a method that is named
    std::vector<std::string> steps;       ///< methods whose accuracy is set by the step
    std::vector<std::string> tolerances;  ///< methods whose accuracy is set by the tolerance
    std::vector<std::string>
        references;  ///< two methods: the first gives the reference, the second confirms it
};

/// Reads a [study] table and checks it against the module's options. Nothing when it had faults.
std::optional<StudySpec> read_study(const Node& table, std::span<const OptionSpec> options,
                                    Diagnostics& faults);

}  // namespace orbweaver
