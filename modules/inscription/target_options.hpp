#pragma once

#include "orbweaver/options.hpp"
#include "target_recipe.hpp"

namespace orbweaver::inscription {

/// The recipe that a scene's options name: `target` (a picture or a baked file), `text`, `threshold`, `invert`,
/// `low_pass`, `margin`, `font`, `weight`, `align`, `line_spacing`, `gaps`, `gaps_seed` and `resolution` (of
/// the raster's sides). With `lines = "words"` each word of the text is a line, whatever blanks and line breaks
/// part it from others. What a manifest does not declare, and what the scene leaves out of what has no default,
/// is as in TargetRecipe. Throws Fault(invalid) where both `target` and `text` are given, or nothing at all is.
TargetRecipe target_recipe(const Options& options);

/// A fault for each option that the scene gives and that makes no difference to what target_recipe() gives, and
/// for a `mode` that has no use for it: random gaps beside words or a picture, gaps to be written legibly.
Diagnostics idle_options(const Options& options);

}  // namespace orbweaver::inscription
