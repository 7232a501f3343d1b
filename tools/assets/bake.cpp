#include "bake.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "orbweaver/fault.hpp"
#include "picture/decode.hpp"
#include "run/run_scene.hpp"

namespace orbweaver {

namespace {

struct Asset {
    std::string option;  ///< "view.sky"
    std::string path;
    Location where;
};

std::vector<Asset> assets_of(const Plan& plan) {
    std::vector<Asset> assets;
    for (const PlannedModule& module : plan.modules)
        for (const OptionSpec& spec : module.manifest->options)
            if (spec.type == OptionType::file && module.options.has(spec.key))
                assets.push_back({module.instance + "." + spec.key, module.options.text(spec.key),
                                  module.options.where(spec.key)});
    return assets;
}

bool is_picture(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".hdr";
}

// Pictures and networks are used as they are; what is checked here is that they can be.
std::string check(const Asset& asset) {
    if (!is_picture(asset.path))
        return fmt::format("{} bytes, read as it is", std::filesystem::file_size(asset.path));
    const auto picture = picture::decode_linear(asset.path);
    return fmt::format("{} x {} pixels, sound, read as it is", picture.width, picture.height);
}

}  // namespace

int bake_scene(const std::string& scene_path, const std::vector<std::string>& module_directories) {
    RunSettings settings;
    settings.scene_path = scene_path;
    settings.module_directories = module_directories;
    settings.request.pictures = true;
    PlannedScene planned = plan_scene(settings);
    Diagnostics& faults = planned.plan.faults;
    const auto assets = assets_of(planned.plan);
    for (std::size_t i = 0; i < assets.size(); ++i) {
        try {
            fmt::print("[{}/{}] {}: {}: {}\n", i + 1, assets.size(), assets[i].option, assets[i].path,
                       check(assets[i]));
        } catch (const picture::Unreadable& unreadable) {
            Diagnostic fault = unreadable.diagnostic();
            fault.where = assets[i].where;
            faults.push_back(std::move(fault));
        }
    }
    for (const Diagnostic& fault : faults) fmt::print(stderr, "{}\n", to_string(fault));
    if (!faults.empty()) return static_cast<int>(FaultKind::invalid);
    if (assets.empty()) fmt::print("{}: the scene asks for no asset\n", scene_path);
    return 0;
}

}  // namespace orbweaver
