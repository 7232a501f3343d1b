#pragma once

#include "orbweaver/options.hpp"
#include "target_recipe.hpp"

namespace orbweaver::inscription {

/// The recipe that a scene's options name: `target` (a picture or a baked file), `text`, `threshold`, `invert`,
/// `low_pass`, `margin`, `font`, `weight`, `align`, `line_spacing`, `gaps`, `gaps_seed` and `resolution` (of
/// the raster's sides). With `lines = "words"` each space of the text becomes a new line. What a manifest does
/// not declare, and what the scene leaves out of what has no default, is as in TargetRecipe. Throws
/// Fault(invalid) where both `target` and `text` are given, or nothing at all is.
TargetRecipe target_recipe(const Options& options);

}  // namespace orbweaver::inscription
