#include "bake_target.hpp"

#include <filesystem>

#include "gaps.hpp"
#include "orbweaver/fault.hpp"
#include "target_file.hpp"
#include "target_picture.hpp"
#include "target_text.hpp"

namespace orbweaver {

namespace {

using inscription::Bitmap;
using inscription::TargetRecipe;

void check_picture(const std::string& picture, const std::string& output) {
    if (is_baked_file(picture))
        throw Fault(FaultKind::invalid, picture + ": is baked already; name what it was made from");
    if (std::error_code ignored; std::filesystem::equivalent(picture, output, ignored))
        throw Fault(FaultKind::invalid, output + ": is what is to be baked; name another file to write");
}

Bitmap coverage_of(const TargetRecipe& recipe) {
    if (recipe.picture) return picture_coverage(recipe);
    if (recipe.text) return text_coverage(recipe);
    return {recipe.width, recipe.height};
}

}  // namespace

void bake_target(const TargetRecipe& recipe, const std::string& output) {
    if (recipe.picture) check_picture(*recipe.picture, output);
    Bitmap coverage = coverage_of(recipe);
    if (recipe.gaps > 0) {
        const Bitmap gaps = inscription::random_gaps(recipe.width, recipe.height, recipe.gaps, recipe.seed);
        for (std::size_t i = 0; i < gaps.values.size(); ++i) coverage.values[i] |= gaps.values[i];
    }
    inscription::write_target(output, coverage, source_hash(recipe), recipe_text(recipe));
}

}  // namespace orbweaver
