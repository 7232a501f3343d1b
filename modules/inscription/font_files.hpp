#pragma once

#include <cstdint>
#include <string>

namespace orbweaver::inscription {

enum class FontWeight : std::uint8_t { regular, bold };

/// The font of targets that name none: of Debian's fonts-dejavu-core, which tools/setup installs.
inline constexpr const char* kDefaultFont = "DejaVu Sans";

/// The file of a font: `font` itself where that is a file, else the file below /usr/share/fonts,
/// /usr/local/share/fonts and ~/.local/share/fonts that is named after the family ("DejaVu Sans" in bold:
/// DejaVuSans-Bold.ttf; letters and digits count, case does not). A family without a bold file gives its
/// regular one. Throws Fault(invalid), with the remedy, where there is none.
std::string find_font(const std::string& font, FontWeight weight);

}  // namespace orbweaver::inscription
