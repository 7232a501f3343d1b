#include "bake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "bake_mesh.hpp"
#include "bake_target.hpp"
#include "mesh_cache.hpp"
#include "mesh_file.hpp"
#include "orbweaver/fault.hpp"
#include "output/progress.hpp"
#include "picture/decode.hpp"
#include "run/run_scene.hpp"
#include "target_cache.hpp"
#include "target_file.hpp"
#include "target_options.hpp"

namespace orbweaver {

namespace {

struct Asset {
    std::string option;  ///< "view.sky"
    std::string kind;    ///< "mesh", "target"; empty: used as it is
    std::string path;    ///< empty for one that is not made from a file
    Location where;
    const Options* options = nullptr;  ///< of its module
};

bool is_asset(const OptionSpec& spec) { return spec.type == OptionType::file || spec.asset == "target"; }

/// A target is made from several options together: the first that is given stands for them.
std::vector<Asset> assets_of(const Plan& plan) {
    std::vector<Asset> assets;
    for (const PlannedModule& module : plan.modules) {
        bool has_target = false;
        for (const OptionSpec& spec : module.manifest->options) {
            if (!is_asset(spec) || !module.options.has(spec.key)) continue;
            if (spec.asset == "target" && std::exchange(has_target, true)) continue;
            assets.push_back({module.instance + "." + spec.key, spec.asset,
                              spec.type == OptionType::file ? module.options.text(spec.key) : "",
                              module.options.where(spec.key), &module.options});
        }
    }
    return assets;
}

bool is_picture(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".hdr";
}

/// Bakes a mesh into the cache, once.
std::string make_mesh_ready(const std::string& path) {
    const auto size = [](const BakedFile& file) {
        return fmt::format("{} triangles, {} bytes", mesh::mesh_in(file).triangles.size(), file.size());
    };
    if (is_baked_file(path)) return size(mesh::open_mesh(path)) + ", baked, read as it is";
    const mesh::Recipe recipe;
    if (const auto cached = mesh::find_cached(path, recipe))
        return fmt::format("{}, baked before: {}", size(*cached), cached->path());
    bake_mesh(path, recipe, {}, mesh::cached_path(path, recipe));
    const BakedFile baked = mesh::open_mesh(path);
    return fmt::format("{}, baked: {}", size(baked), baked.path());
}

/// Bakes what is to be inscribed into the cache, once.
std::string make_target_ready(const inscription::TargetRecipe& recipe) {
    const auto size = [](const BakedFile& file) {
        const inscription::Target target = inscription::target_in(file);
        return fmt::format("{} x {} pixels", target.width, target.height);
    };
    if (recipe.picture && is_baked_file(*recipe.picture))
        return size(inscription::open_target(recipe)) + ", baked, read as it is";
    if (const auto cached = inscription::find_cached(recipe))
        return fmt::format("{}, baked before: {}", size(*cached), cached->path());
    bake_target(recipe, inscription::cached_path(recipe));
    const BakedFile baked = inscription::open_target(recipe);
    return fmt::format("{}, baked: {}", size(baked), baked.path());
}

// Pictures and networks are used as they are; what is checked here is that they can be.
std::string make_ready(const Asset& asset) {
    if (asset.kind == "mesh") return make_mesh_ready(asset.path);
    if (asset.kind == "target") return make_target_ready(inscription::target_recipe(*asset.options));
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
    int code = faults.empty() ? 0 : static_cast<int>(FaultKind::invalid);
    for (const Asset& asset : assets)
        if (asset.kind == "target")
            for (Diagnostic& fault : inscription::idle_options(*asset.options)) {
                faults.push_back(std::move(fault));
                code = static_cast<int>(FaultKind::invalid);
            }
    Progress progress("bake", 0, assets.size(), 0, assets.empty(), "assets");
    for (std::size_t i = 0; i < assets.size(); ++i) {
        const Asset& asset = assets[i];
        try {
            fmt::print("[{}/{}] {}: {}{}\n", i + 1, assets.size(), asset.option,
                       asset.path.empty() ? "" : asset.path + ": ", make_ready(asset));
        } catch (const picture::Unreadable& unreadable) {
            faults.push_back(unreadable.diagnostic());
            faults.back().where = asset.where;
            code = std::max(code, static_cast<int>(unreadable.kind()));
        } catch (const Fault& fault) {
            faults.push_back({asset.where, fault.what(), "", ""});
            code = std::max(code, static_cast<int>(fault.kind()));
        }
        progress.update(i + 1);
    }
    for (const Diagnostic& fault : faults) fmt::print(stderr, "{}\n", to_string(fault));
    if (assets.empty() && faults.empty()) fmt::print("{}: the scene asks for no asset\n", scene_path);
    return code;
}

}  // namespace orbweaver
