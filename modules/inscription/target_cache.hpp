#pragma once

#include <optional>
#include <string>

#include "orbweaver/baked_file.hpp"
#include "target_recipe.hpp"

namespace orbweaver::inscription {

/// Where the target of this recipe belongs in the cache (see cache_folder()): named after the source's bytes,
/// the recipe and the versions of file and builder. Throws Fault(invalid) for a source that cannot be read.
std::string cached_path(const TargetRecipe& recipe);

/// What was baked by this recipe, if it is there and sound.
std::optional<BakedFile> find_cached(const TargetRecipe& recipe);

/// A target to be inscribed: the picture itself where that is a baked file, or what
/// `orbweaver-assets bake SCENE` made. Throws Fault(invalid) for one that is not baked yet, or of which the
/// cache holds something damaged, and says how it is made.
BakedFile open_target(const TargetRecipe& recipe);

}  // namespace orbweaver::inscription
