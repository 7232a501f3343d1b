#pragma once

#include "run/run_scene.hpp"

namespace orbweaver {

/// Throws CLI::ValidationError for an output of a run that would overwrite another one, the scene, or a file
/// that the scene reads. A scene that cannot be read is left to the run, which says why.
void check_outputs(const RunSettings& settings);

}  // namespace orbweaver
