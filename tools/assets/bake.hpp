#pragma once

#include <string>
#include <vector>

namespace orbweaver {

/// Makes ready every asset that a scene asks for, and no other: bakes meshes into the cache unless they are
/// there, and checks that everything else can be read and is sound. Prints a line for each on standard output,
/// and every fault on standard error. Returns the exit code.
int bake_scene(const std::string& scene_path, const std::vector<std::string>& module_directories);

}  // namespace orbweaver
