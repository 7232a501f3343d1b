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

/// Neither picture nor font is written over.
void check_output(const TargetRecipe& recipe, const std::string& output) {
    std::error_code ignored;
    if (recipe.picture && std::filesystem::equivalent(*recipe.picture, output, ignored))
        throw Fault(FaultKind::invalid, output + ": is what is to be baked; name another file to write");
    if (recipe.text && std::filesystem::equivalent(find_font(recipe.font, recipe.weight), output, ignored))
        throw Fault(FaultKind::invalid,
                    output + ": is the font that the words are drawn in; name another file to write");
}

Bitmap coverage_of(const TargetRecipe& recipe) {
    if (recipe.picture) return picture_coverage(recipe);
    if (recipe.text) return text_coverage(recipe);
    return {recipe.width, recipe.height};
}

}  // namespace

void bake_target(const TargetRecipe& recipe, const std::string& output) {
    if (recipe.picture && is_baked_file(*recipe.picture))
        throw Fault(FaultKind::invalid, *recipe.picture + ": is baked already; name what it was made from");
    check_output(recipe, output);
    Bitmap coverage = coverage_of(recipe);
    if (recipe.gaps > 0) {
        const Bitmap gaps = inscription::random_gaps(recipe.width, recipe.height, recipe.gaps, recipe.seed);
        for (std::size_t i = 0; i < gaps.values.size(); ++i) coverage.values[i] |= gaps.values[i];
    }
    inscription::write_target(output, coverage, source_hash(recipe), recipe_text(recipe));
}

}  // namespace orbweaver
