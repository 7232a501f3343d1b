#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "run/run_scene.hpp"
#include "run/session.hpp"

namespace orbweaver {

/// The path of a scene that ships, whose assets are ready from then on.
inline std::string scene_path(const std::string& name) {
    const std::string path = std::string(ORBWEAVER_SOURCE_DIR) + "/assets/scenes/" + name + ".toml";
    static std::set<std::string> ready;
    const std::string bake = std::string(ORBWEAVER_ASSETS_PROGRAM) + " bake '" + path + "' > /dev/null 2>&1";
    if (ready.insert(path).second && std::system(bake.c_str()) != 0)
        throw std::runtime_error("orbweaver-assets bake " + path + " failed");
    return path;
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
