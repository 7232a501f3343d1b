#pragma once

#include <string>
#include <vector>

#include "plan/manifest.hpp"

namespace orbweaver {

/// The modules there are: every manifest in the searched folders, by id.
struct Catalog {
    std::vector<std::string> directories;  ///< searched, in order
    std::vector<Manifest> manifests;       ///< sorted by id
    Diagnostics faults;                    ///< folders and manifests that could not be read, tables met twice
};

/// The folders to search: those asked for, then ORBWEAVER_MODULES (separated by ':'), then the one that came
/// with the program.
std::vector<std::string> module_directories(const std::vector<std::string>& asked);

/// The folders like assets/: the scene's own neighbours first, then what came with the program.
std::vector<std::string> asset_directories(const std::string& scene_directory);

/// Of modules with one id, the folder searched first has the one that counts.
Catalog read_catalog(const std::vector<std::string>& directories);

/// The manifest of that id, or null.
const Manifest* find(const Catalog& catalog, std::string_view id) noexcept;

}  // namespace orbweaver
