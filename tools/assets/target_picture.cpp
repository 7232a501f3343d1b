#include "target_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "low_pass.hpp"
#include "orbweaver/fault.hpp"
#include "otsu.hpp"
#include "picture/decode.hpp"
#include "resample.hpp"

namespace orbweaver {

namespace {

using inscription::Bitmap;
using inscription::ByteShades;
using inscription::Shades;
using inscription::TargetRecipe;

ByteShades shades_of(const std::string& path) {
    auto picture = picture::decode_gray(path);
    ByteShades shades;
    shades.width = static_cast<std::uint32_t>(picture.width);
    shades.height = static_cast<std::uint32_t>(picture.height);
    shades.values = std::move(picture.shades);
    return shades;
}

/// As large as fits between the margins.
Shades fitted(const ByteShades& picture, const TargetRecipe& recipe) {
    const double margin = recipe.margin_or_default() * std::min(recipe.width, recipe.height);
    const double scale =
        std::min((recipe.width - 2 * margin) / picture.width, (recipe.height - 2 * margin) / picture.height);
    const auto side = [&](std::uint32_t from, std::uint32_t most) {
        return static_cast<std::uint32_t>(
            std::clamp(std::floor(scale * from + 0.5), 1.0, static_cast<double>(most)));
    };
    return resample(picture, side(picture.width, recipe.width), side(picture.height, recipe.height));
}

[[noreturn]] void refuse_one_shade(const TargetRecipe& recipe, const std::string& when,
                                   const std::string& remedy) {
    throw Fault(FaultKind::invalid, *recipe.picture + ": is of one shade throughout" + when +
                                        "; expected something dark on something bright, so " + remedy);
}

Shades blurred(Shades shades, const TargetRecipe& recipe) {
    if (recipe.low_pass == 0) return shades;
    shades = low_pass(shades, recipe.low_pass);
    if (!inscription::otsu_threshold(shades))
        refuse_one_shade(recipe, fmt::format(" when it is blurred by {:g} pixels", recipe.low_pass),
                         "blur it less");
    return shades;
}

void check_both_shades(std::size_t dark, std::size_t all, double threshold, const TargetRecipe& recipe) {
    if (dark > 0 && dark < all) return;
    throw Fault(
        FaultKind::invalid,
        fmt::format("{}: {} of it is {} than {:g}; expected something to be inscribed and something not, so "
                    "name another threshold",
                    *recipe.picture, dark == 0 ? "nothing" : "all", recipe.invert ? "brighter" : "darker",
                    threshold));
}

}  // namespace

Bitmap picture_coverage(const TargetRecipe& recipe) {
    Shades sharp = fitted(shades_of(*recipe.picture), recipe);
    if (!inscription::otsu_threshold(sharp)) refuse_one_shade(recipe, "", "name another picture");
    const Shades shades = blurred(std::move(sharp), recipe);
    const double threshold = recipe.threshold.value_or(*inscription::otsu_threshold(shades));
    Bitmap coverage(recipe.width, recipe.height);
    const std::uint32_t left = (recipe.width - shades.width) / 2, top = (recipe.height - shades.height) / 2;
    std::size_t dark = 0;
    for (std::uint32_t y = 0; y < shades.height; ++y)
        for (std::uint32_t x = 0; x < shades.width; ++x) {
            const bool inscribed = (shades.row(y)[x] < threshold) != recipe.invert;
            coverage.row(top + y)[left + x] = inscribed ? 1 : 0;
            dark += inscribed ? 1 : 0;
        }
    check_both_shades(dark, shades.values.size(), threshold, recipe);
    return coverage;
}

}  // namespace orbweaver
