#include "target_cache.hpp"

#include <filesystem>

#include "baked/cache_folder.hpp"
#include "baked/content_hash.hpp"
#include "orbweaver/fault.hpp"
#include "target_file.hpp"

namespace orbweaver::inscription {

namespace {

ContentHash key_of(const TargetRecipe& recipe) {
    ContentHasher key;
    key.add(kTargetType);
    const ContentHash source = source_hash(recipe);
    key.add(&source, sizeof source);
    for (const std::uint32_t version : {kTargetVersion, kTargetBuilder}) key.add(&version, sizeof version);
    key.add(recipe_text(recipe));
    return key.finish();
}

/// For sentences.
std::string name_of(const TargetRecipe& recipe) {
    if (recipe.picture) return *recipe.picture;
    return recipe.text ? "the text '" + *recipe.text + "'" : "a target of random gaps";
}

bool exists(const std::string& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

BakedFile open(const std::string& path) { return {path, kTargetType, kTargetVersion}; }

}  // namespace

std::string cached_path(const TargetRecipe& recipe) {
    return cache_folder() + "/" + to_string(key_of(recipe)) + ".baked";
}

std::optional<BakedFile> find_cached(const TargetRecipe& recipe) {
    const std::string path = cached_path(recipe);
    if (!exists(path)) return std::nullopt;
    try {
        return open(path);
    } catch (const Fault&) {
        return std::nullopt;  // damaged: as good as absent, since it can be made again
    }
}

BakedFile open_target(const TargetRecipe& recipe) {
    if (recipe.picture && is_baked_file(*recipe.picture)) return open(*recipe.picture);
    const std::string path = cached_path(recipe);
    if (!exists(path))
        throw Fault(FaultKind::invalid,
                    name_of(recipe) +
                        ": is not baked yet; run orbweaver-assets bake with this scene, or bake it "
                        "with orbweaver-assets target and name the baked file");
    try {
        return open(path);
    } catch (const Fault& fault) {
        throw Fault(FaultKind::invalid,
                    name_of(recipe) + ": was baked, but what is kept of it cannot be used (" + fault.what() +
                        "); orbweaver-assets bake, with this scene, makes it anew in the cache");
    }
}

}  // namespace orbweaver::inscription
