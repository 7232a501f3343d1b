#pragma once

#include <string>
#include <vector>

#include "run/run_scene.hpp"

namespace orbweaver::study {

/// What a command line asks of a study.
struct StudySettings {
    RunSettings run;             ///< scene, overrides, folders of modules, threads, quiet; the rest stays empty
    std::string out;             ///< folder of the results
    std::string table;           ///< of the scene, whose module is studied; empty: the only one that can be
    bool full_duration = false;  ///< each run lasts as long as the scene says; else no longer than is usual
    double time = 300;           ///< s of wall clock that the whole study may take
    int repeats = 3;             ///< timed runs of which the median counts
    std::vector<std::string> references;  ///< two methods, instead of those that the module names; empty: those
    std::vector<std::string> methods;     ///< empty: all that the module can be studied with
};

}  // namespace orbweaver::study
