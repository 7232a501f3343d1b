#pragma once

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "run/run_scene.hpp"
#include "run/session.hpp"

namespace orbweaver {

inline std::string scene_path(const std::string& name) {
    return std::string(ORBWEAVER_SOURCE_DIR) + "/assets/scenes/" + name + ".toml";
}

/// The names of all scenes that ship, sorted.
inline std::vector<std::string> shipped_scenes() {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(ORBWEAVER_SOURCE_DIR) + "/assets/scenes"))
        if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// A session of a scene, as the command line would make it. The catalog outlives the session.
struct OpenScene {
    PlannedScene planned;
    std::unique_ptr<Session> session;
};

inline OpenScene open_scene_file(const std::string& path, Request request = {},
                                 std::vector<std::string> overrides = {}) {
    RunSettings settings;
    settings.scene_path = path;
    settings.module_directories = {ORBWEAVER_MODULE_DIR};
    settings.request = request;
    settings.overrides = std::move(overrides);
    OpenScene scene;
    scene.planned = plan_scene(settings);
    if (!scene.planned.plan.faults.empty())
        throw Fault(FaultKind::invalid, to_string(scene.planned.plan.faults.front()));
    scene.session = std::make_unique<Session>(scene.planned.plan, request);
    return scene;
}

/// One that ships, by name.
inline OpenScene open_scene(const std::string& name, Request request = {},
                            std::vector<std::string> overrides = {}) {
    return open_scene_file(scene_path(name), std::move(request), std::move(overrides));
}

}  // namespace orbweaver
