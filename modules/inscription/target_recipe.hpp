#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "font_files.hpp"
#include "orbweaver/baked_file.hpp"

namespace orbweaver::inscription {

/// Of lines among each other.
enum class Align : std::uint8_t { left, center, right };

/// How a target is made: of a picture, or of text, or of random gaps alone.
struct TargetRecipe {
    std::optional<std::string> picture;  ///< the path of a PNG, JPEG or Radiance HDR file
    std::optional<std::string> text;     ///< UTF-8, lines parted by '\n'
    std::uint32_t width = 600;           ///< pixels (the thesis's)
    std::uint32_t height = 600;
    std::optional<double> margin;  ///< share of the shorter side; absent: 0 of a picture, 0.05 of text

    std::optional<double> threshold;  ///< shade, 0 to 1, below which a picture is dark; absent: Otsu's
    bool invert = false;              ///< what is bright in the picture is to be inscribed
    double low_pass = 0;              ///< standard deviation of the blur before the threshold, pixels; 0: none

    std::string font = kDefaultFont;  ///< a file or a family, see find_font()
    FontWeight weight = FontWeight::bold;
    Align align = Align::center;
    double line_spacing = 1;  ///< of the font's own

    double gaps = 0;  ///< share of all pixels that random gaps darken, 0 to 0.5
    std::uint64_t seed = 1;

    double margin_or_default() const { return margin.value_or(text ? 0.05 : 0.0); }
};

/// All that makes one target another than a second from the same source, as lines of "key: value".
/// Throws Fault(invalid) where text names a font that is not there.
std::string recipe_text(const TargetRecipe& recipe);

/// The words in lines that recipe_text() gave; nothing for a picture, or for gaps alone.
std::optional<std::string> words_in(std::string_view recipe_text);

/// A text without line breaks, for recipes and sentences: they become "\n", and a backslash becomes two.
std::string one_line(const std::string& text);

/// Of the picture's bytes, or of the words and the font's bytes. Throws Fault(invalid) for what cannot be read.
ContentHash source_hash(const TargetRecipe& recipe);

}  // namespace orbweaver::inscription
