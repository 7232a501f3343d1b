#include "font.hpp"

#include <fmt/format.h>

#include <new>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Fault(FaultKind::invalid,
                fmt::format("{}: {}; name a TrueType or OpenType font with outlines", path, what));
}

}  // namespace

Font::Font(const std::string& path, inscription::FontWeight weight) : path_(path) {
    if (FT_Init_FreeType(&library_) != 0) throw std::bad_alloc();
    const FT_Error error = FT_New_Face(library_, path.c_str(), 0, &face_);
    const bool sound = error == 0 && FT_IS_SFNT(face_) && FT_IS_SCALABLE(face_) && face_->units_per_EM > 0;
    if (!sound) {
        FT_Done_FreeType(library_);  // and the face with it
        refuse(path, error != 0 ? fmt::format("cannot be read as a font (FreeType's error {:#x})", error)
                                : "is a font without outlines");
    }
    if (weight == inscription::FontWeight::bold && (face_->style_flags & FT_STYLE_FLAG_BOLD) == 0)
        growth_ = face_->units_per_EM / 24;
}

Font::~Font() { FT_Done_FreeType(library_); }

FT_Outline& Font::outline(std::uint32_t glyph) const {
    if (FT_Load_Glyph(face_, glyph, FT_LOAD_NO_SCALE) != 0 || face_->glyph->format != FT_GLYPH_FORMAT_OUTLINE)
        refuse(path_, fmt::format("glyph {} cannot be read", glyph));
    FT_Outline& outline = face_->glyph->outline;
    if (growth_ > 0 && outline.n_points > 0) FT_Outline_Embolden(&outline, growth_);
    return outline;
}

}  // namespace orbweaver
