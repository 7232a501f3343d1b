#include "target_cache.hpp"

#include "baked/cached_file.hpp"
#include "baked/content_hash.hpp"
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
    return recipe.text ? "the text '" + one_line(*recipe.text) + "'" : "a target of random gaps";
}

/// What was baked by this recipe, if it is there. Throws DamagedCache where it cannot be used.
std::optional<BakedFile> sound_cached(const TargetRecipe& recipe) {
    return open_cached(cached_path(recipe), kTargetType, kTargetVersion, name_of(recipe));
}

}  // namespace

std::string cached_path(const TargetRecipe& recipe) { return orbweaver::cached_path(key_of(recipe)); }

std::optional<BakedFile> find_cached(const TargetRecipe& recipe) {
    return if_sound([&] { return sound_cached(recipe); });
}

BakedFile open_target(const TargetRecipe& recipe) {
    if (recipe.picture && is_baked_file(*recipe.picture)) return {*recipe.picture, kTargetType, kTargetVersion};
    if (auto file = sound_cached(recipe)) return std::move(*file);
    refuse_unbaked(name_of(recipe), "target");
}

}  // namespace orbweaver::inscription
