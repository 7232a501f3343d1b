#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "study/motion.hpp"
#include "study/subject.hpp"
#include "study/time_budget.hpp"

namespace orbweaver::study {

/// How a trial ended.
enum class Ending : std::uint8_t {
    done,
    diverged,  ///< stopped by the first value that means nothing
    refused,   ///< not even begun: it would have diverged, taken too many steps, or the method does not take it
    limit,     ///< a limit was hit: memory, size
    timeout,   ///< the time for it was over
};
const char* to_string(Ending ending) noexcept;

/// One run of a scene, watched.
struct Trial {
    Ending ending = Ending::done;
    std::string message;  ///< the sentence behind an ending other than done
    Motion motion;
    double wall_s = 0;     ///< s in the subject's frames, less what it estimates errors with
    double elapsed_s = 0;  ///< s for everything, loading and set-up included
    std::uint64_t steps = 0;
    double stable_step_s = std::numeric_limits<double>::infinity();  ///< of the shortest among the instances
};

/// What to run.
struct TrialPlan {
    std::vector<std::string> overrides;  ///< applied after the user's own
    double duration = 0;                 ///< s; 0: set up, and run nothing
    std::vector<Vec3> offsets = {};      ///< m, added to each particle before the first frame; empty: none
};

/// Sets the scene up as it is and runs nothing. Throws Fault where it is invalid or beyond a limit.
void set_up(const StudySettings& settings, const Subject& subject);
/// Runs the scene with these overrides, headless, until its end or the deadline. What cannot be set up so is
/// refused. Throws Fault for overrides that the plan refuses and modules that fail, and Fault(limit) when the
/// motion takes more than half a GB.
Trial run_trial(const StudySettings& settings, const Subject& subject, const TrialPlan& plan,
                const Deadline& deadline);
/// The longest step (s) that the module's adviser holds for stable with this method, the scene changed by these
/// overrides; found by setting it up, without running it.
double stable_step(const StudySettings& settings, const Subject& subject, const std::string& method,
                   const std::vector<std::string>& changes, const Deadline& deadline);

}  // namespace orbweaver::study
