#pragma once

#include <string>

#include "target_recipe.hpp"

namespace orbweaver {

/// Makes a target by its recipe and writes it as a baked file. Throws as picture_coverage(), text_coverage()
/// and AtomicFile do, and Fault(invalid) for a picture that is a baked file already and for an output that is
/// the picture or the font.
void bake_target(const inscription::TargetRecipe& recipe, const std::string& output);

}  // namespace orbweaver
