#pragma once

#include "raster.hpp"
#include "target_recipe.hpp"

namespace orbweaver {

/// The picture of a recipe as large as fits between its margins, in the middle and in its own proportions (at
/// least a pixel wide and high): dark where it is darker than the threshold, or brighter with `invert`. What
/// lies beside the picture is not to be inscribed. Throws picture::Unreadable for a picture that cannot be had,
/// and Fault(invalid) for one in which everything or nothing is dark.
inscription::Bitmap picture_coverage(const inscription::TargetRecipe& recipe);

}  // namespace orbweaver
