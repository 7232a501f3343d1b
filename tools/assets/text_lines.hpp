#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace orbweaver {

inline constexpr std::size_t kMostCharacters = 1000;  ///< of a text to be inscribed

/// The lines of a text in UTF-8, parted by '\n'. Throws Fault(invalid) for a text without letters, bytes that
/// are no UTF-8, and control characters, those included that no font draws and only other programs obey;
/// Fault(limit) for more than kMostCharacters.
std::vector<std::string> text_lines(const std::string& text);

/// The character that begins at the front of sound UTF-8, for sentences: "'\u00e9' (U+00E9)".
std::string character_name(std::string_view text);

}  // namespace orbweaver
