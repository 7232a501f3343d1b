#pragma once

#include <span>
#include <string>
#include <vector>

#include "orbweaver/options.hpp"
#include "plan/manifest.hpp"

namespace orbweaver {

/// Where options of type file and preset look.
struct AssetPaths {
    std::string scene_directory;
    std::vector<std::string> asset_directories;  ///< folders like assets/, first wins
};

/// Checks one table of a scene against the options of a manifest: unknown keys, types, units, ranges,
/// choices, files, presets, missing keys. Appends every fault; the result is whole only if there was none.
Options check_options(const Node& table, std::span<const OptionSpec> specs, const AssetPaths& paths,
                      Diagnostics& faults);

}  // namespace orbweaver
