#pragma once

#include <freetype/freetype.h>
#include <freetype/ftoutln.h>

#include <cstdint>
#include <string>

#include "font_files.hpp"

namespace orbweaver {

/// An outline font, opened by FreeType. Lengths are in the font's own units, y up.
class Font {
public:
    /// Throws Fault(invalid) for a file that is no TrueType or OpenType font with outlines. A font that is not
    /// bold is grown where bold is asked: by 1/24 em, as FreeType does.
    Font(const std::string& path, inscription::FontWeight weight);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    FT_Library library() const noexcept { return library_; }
    FT_Face face() const noexcept { return face_; }
    const std::string& path() const noexcept { return path_; }
    double em() const noexcept { return face_->units_per_EM; }
    /// Added to the strokes of every letter, and so to what it takes of its line.
    FT_Pos growth() const noexcept { return growth_; }

    /// A glyph's outline, grown where that is asked, valid until the next is asked for.
    FT_Outline& outline(std::uint32_t glyph) const;

private:
    std::string path_;
    FT_Library library_ = nullptr;
    FT_Face face_ = nullptr;
    FT_Pos growth_ = 0;
};

}  // namespace orbweaver
