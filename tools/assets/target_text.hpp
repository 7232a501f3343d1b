#pragma once

#include "raster.hpp"
#include "target_recipe.hpp"

namespace orbweaver {

inline constexpr double kSmallestEm = 12;  ///< pixels: smaller letters cannot be told from each other

/// The words of a recipe as large as fits between its margins, in the middle: dark where letters cover half of
/// a pixel or more. Throws Fault(invalid) for what text_lines(), find_font(), Font and lay_out() refuse and for
/// text without anything to draw; Fault(limit) for text so long that an em is below kSmallestEm.
inscription::Bitmap text_coverage(const inscription::TargetRecipe& recipe);

}  // namespace orbweaver
