#include "target_text.hpp"

#include <fmt/format.h>
#include <freetype/ftbbox.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "orbweaver/fault.hpp"
#include "text_layout.hpp"
#include "text_lines.hpp"

namespace orbweaver {

namespace {

using inscription::Bitmap;
using inscription::TargetRecipe;

constexpr double kLargestScale = 256;  ///< pixels a unit: beyond any font that is not made to hurt
constexpr std::uint8_t kHalf = 128;    ///< of a pixel's coverage, 0 to 255

/// What ink covers, in units of the font, y up.
struct Extent {
    double left = std::numeric_limits<double>::infinity(), bottom = left;
    double right = -left, top = -left;
    double width() const { return right - left; }
    double height() const { return top - bottom; }
    bool empty() const { return !(width() > 0 && height() > 0); }
};

Extent extent_of(const std::vector<PlacedGlyph>& glyphs, const Font& font) {
    Extent all;
    for (const PlacedGlyph& each : glyphs) {
        FT_Outline& outline = font.outline(each.glyph);
        FT_BBox box{};
        if (outline.n_points == 0 || FT_Outline_Get_BBox(&outline, &box) != 0) continue;
        all.left = std::min(all.left, each.x + static_cast<double>(box.xMin));
        all.right = std::max(all.right, each.x + static_cast<double>(box.xMax));
        all.bottom = std::min(all.bottom, each.y + static_cast<double>(box.yMin));
        all.top = std::max(all.top, each.y + static_cast<double>(box.yMax));
    }
    return all;
}

/// From the font's units to pixels, y still up.
struct Placement {
    double scale;
    double x, y;  ///< where the font's origin comes to lie, pixels
};

Placement fit(const Extent& extent, const TargetRecipe& recipe) {
    const double width = recipe.width, height = recipe.height;
    const double margin = recipe.margin_or_default() * std::min(width, height);
    const double scale = std::min(
        {(width - 2 * margin) / extent.width(), (height - 2 * margin) / extent.height(), kLargestScale});
    return {scale, (width - scale * (extent.left + extent.right)) / 2,
            (height - scale * (extent.bottom + extent.top)) / 2};
}

/// Takes spans of an outline where they are darker than what was there.
void take_spans(int y, int count, const FT_Span* spans, void* user) {
    auto& raster = *static_cast<Bitmap*>(user);
    std::uint8_t* row = raster.row(raster.height - 1 - static_cast<std::uint32_t>(y));
    for (int i = 0; i < count; ++i)
        for (int x = spans[i].x; x < spans[i].x + spans[i].len; ++x)
            row[x] = std::max(row[x], static_cast<std::uint8_t>(spans[i].coverage));
}

FT_Pos in_64ths(double pixels) { return static_cast<FT_Pos>(std::floor(64 * pixels + 0.5)); }

void draw(FT_Outline& outline, double x, double y, double scale, const Font& font, Bitmap& raster) {
    const auto factor = static_cast<FT_Fixed>(scale * 64 * 65536);
    const FT_Matrix matrix{factor, 0, 0, factor};
    FT_Outline_Transform(&outline, &matrix);
    FT_Outline_Translate(&outline, in_64ths(x), in_64ths(y));
    FT_Raster_Params parameters{};
    parameters.flags = FT_RASTER_FLAG_AA | FT_RASTER_FLAG_DIRECT | FT_RASTER_FLAG_CLIP;
    parameters.gray_spans = take_spans;
    parameters.user = &raster;
    parameters.clip_box = {0, 0, static_cast<FT_Pos>(raster.width), static_cast<FT_Pos>(raster.height)};
    if (const FT_Error error = FT_Outline_Render(font.library(), &outline, &parameters); error != 0)
        throw Fault(FaultKind::invalid,
                    fmt::format("{}: a letter cannot be drawn (FreeType's error {:#x}); name another font",
                                font.path(), error));
}

}  // namespace

Bitmap text_coverage(const TargetRecipe& recipe) {
    const auto lines = text_lines(*recipe.text);
    const Font font(inscription::find_font(recipe.font, recipe.weight), recipe.weight);
    const auto glyphs = lay_out(lines, font, recipe.align, recipe.line_spacing);
    const Extent extent = extent_of(glyphs, font);
    if (extent.empty())
        throw Fault(FaultKind::invalid, "the text has nothing to draw; name words, such as \"SOME PIG\"");
    const Placement place = fit(extent, recipe);
    if (place.scale * font.em() < kSmallestEm)
        throw Fault(
            FaultKind::limit,
            fmt::format("the text's letters would be {:.1f} pixels high (1 em); expected at least {}: fewer "
                        "words, more lines, or a larger target",
                        place.scale * font.em(), kSmallestEm));
    Bitmap raster(recipe.width, recipe.height);
    for (const PlacedGlyph& each : glyphs)
        draw(font.outline(each.glyph), place.x + place.scale * each.x, place.y + place.scale * each.y,
             place.scale, font, raster);
    for (std::uint8_t& value : raster.values) value = value >= kHalf ? 1 : 0;
    return raster;
}

}  // namespace orbweaver
