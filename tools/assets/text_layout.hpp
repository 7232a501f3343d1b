#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "font.hpp"
#include "target_recipe.hpp"

namespace orbweaver {

/// A glyph and its origin, in units of the font, y up.
struct PlacedGlyph {
    std::uint32_t glyph = 0;
    double x = 0;
    double y = 0;
};

/// Lines of text as glyphs: each line shaped by HarfBuzz (kerning, ligatures, the script's own rules), aligned
/// by its width, the first line's baseline at y = 0. Throws Fault(invalid) naming every character that the font
/// lacks.
std::vector<PlacedGlyph> lay_out(const std::vector<std::string>& lines, const Font& font,
                                 inscription::Align align, double line_spacing);

}  // namespace orbweaver
