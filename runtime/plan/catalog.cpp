#include "plan/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace orbweaver {

namespace fs = std::filesystem;

namespace {

fs::path program_directory() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path();
}

std::vector<std::string> manifest_paths(const std::string& directory, Diagnostics& faults) {
    std::vector<std::string> paths;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(directory, error))
        if (entry.path().extension() == ".toml") paths.push_back(entry.path().string());
    if (error)
        faults.push_back({{directory, 0, 0},
                          "modules cannot be searched here: " + error.message(),
                          "a folder",
                          "correct --modules or ORBWEAVER_MODULES"});
    std::sort(paths.begin(), paths.end());
    return paths;
}

/// Whether `table` has nobody to answer to it yet.
bool is_free(const Catalog& catalog, const std::string& table) {
    return table.empty() ||
           (table != "scene" && std::none_of(catalog.manifests.begin(), catalog.manifests.end(),
                                             [&](const Manifest& m) { return m.table == table; }));
}

void add_manifest(const std::string& path, Catalog& catalog) {
    auto manifest = read_manifest(path, catalog.faults);
    if (!manifest || find(catalog, manifest->id) != nullptr) return;
    if (!is_free(catalog, manifest->table)) {
        catalog.faults.push_back({{path, 0, 0},
                                  fmt::format("another module answers to [{}] already", manifest->table),
                                  "one module for each table",
                                  "remove one of the two, or search fewer folders"});
        return;
    }
    catalog.manifests.push_back(std::move(*manifest));
}

}  // namespace

std::vector<std::string> module_directories(const std::vector<std::string>& asked) {
    std::vector<std::string> directories = asked;
    if (const char* variable = std::getenv("ORBWEAVER_MODULES")) {
        std::stringstream list{variable};
        for (std::string each; std::getline(list, each, ':');)
            if (!each.empty()) directories.push_back(each);
    }
    directories.push_back((program_directory() / "../lib/orbweaver/modules").lexically_normal().string());
    return directories;
}

std::vector<std::string> asset_directories(const std::string& scene_directory) {
    std::vector<std::string> directories;
    const fs::path candidates[] = {fs::path(scene_directory), fs::path(scene_directory) / "..",
                                   program_directory() / "../share/orbweaver/assets",
                                   fs::path(ORBWEAVER_SOURCE_ASSETS)};
    std::error_code error;
    for (const fs::path& each : candidates)
        if (fs::is_directory(each, error)) directories.push_back(each.lexically_normal().string());
    return directories;
}

Catalog read_catalog(const std::vector<std::string>& directories) {
    Catalog catalog;
    catalog.directories = directories;
    std::vector<fs::path> searched;
    for (const std::string& directory : directories) {
        std::error_code error;
        const fs::path place = fs::weakly_canonical(directory, error);
        if (std::find(searched.begin(), searched.end(), place) != searched.end()) continue;
        searched.push_back(place);
        for (const std::string& path : manifest_paths(directory, catalog.faults)) add_manifest(path, catalog);
    }
    std::sort(catalog.manifests.begin(), catalog.manifests.end(),
              [](const Manifest& a, const Manifest& b) { return a.id < b.id; });
    return catalog;
}

const Manifest* find(const Catalog& catalog, std::string_view id) noexcept {
    for (const Manifest& manifest : catalog.manifests)
        if (manifest.id == id) return &manifest;
    return nullptr;
}

}  // namespace orbweaver
