#pragma once

#include "orbweaver/module.hpp"
#include "plan/option_check.hpp"

namespace orbweaver {

/// The options of the [scene] table, declared as a module's are.
std::span<const OptionSpec> scene_options();

/// Checks [scene] (all of it may be absent) and gives what it says.
SceneInfo read_scene_table(const Node& scene, const std::string& path, Diagnostics& faults);

}  // namespace orbweaver
