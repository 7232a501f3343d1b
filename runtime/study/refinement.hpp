#pragma once

#include <optional>
#include <vector>

#include "study/trial.hpp"

namespace orbweaver::study {

/// The steps or tolerances of a method from coarse to fine. Steps divide a frame; `coarsest` is about the
/// longest (s) and each is half the one before. Tolerances go down tenfold from 1e-3 m as far as the option
/// allows.
std::vector<Rung> ladder(const Subject& subject, const std::string& method, double coarsest, int count);

/// A method's motion, refined until it changes no more or the time for it is over.
struct Refined {
    Rung rung;            ///< the finest
    Motion motion;        ///< at that
    double change_m = 0;  ///< m, largest distance from the motion one rung before; infinite: there was none
    double order = 0;     ///< at which the last changes shrank; 0: there were fewer than two
    std::optional<Motion> limit;  ///< where the motion goes as the step goes to 0 (Richardson)
};

/// Runs rung after rung, as long as the next, at twice the cost of the last, fits. It stops where a change no
/// longer is below three quarters of the change before: what is left is rounding. Distances are those of the
/// first `rows`. Nothing when not even one rung was run to its end.
std::optional<Refined> refine(const StudySettings& settings, const Subject& subject,
                              const std::vector<Rung>& rungs, double duration, std::size_t rows,
                              const Deadline& deadline);

}  // namespace orbweaver::study
