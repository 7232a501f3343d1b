#include "text_layout.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"

using namespace orbweaver;
using inscription::Align;
using inscription::FontWeight;

namespace {

Font dejavu(FontWeight weight = FontWeight::bold) {
    return {inscription::find_font("DejaVu Sans", weight), weight};
}

/// How far the origins of the first glyph and of the end of a line of `text` lie apart, by FreeType's advances.
double advance_of(const Font& font, const std::string& text) {
    double sum = 0;
    for (const char c : text) {
        FT_Load_Char(font.face(), static_cast<FT_ULong>(c), FT_LOAD_NO_SCALE);
        sum += static_cast<double>(font.face()->glyph->advance.x);
    }
    return sum;
}

}  // namespace

TEST_CASE("letters follow each other by the font's advances, lines by its line height", "[unit]") {
    const Font font = dejavu();
    const auto glyphs = lay_out({"HH", "H"}, font, Align::left, 1);
    REQUIRE(glyphs.size() == 3);
    CHECK(glyphs[0].x == 0);
    CHECK(glyphs[1].x == advance_of(font, "H"));
    CHECK(glyphs[2].x == 0);
    CHECK(glyphs[0].y == 0);
    CHECK(glyphs[2].y == -font.face()->height);
    CHECK(glyphs[0].glyph == FT_Get_Char_Index(font.face(), 'H'));
    CHECK(lay_out({"H", "H"}, font, Align::left, 1.5)[1].y == -1.5 * font.face()->height);
}

TEST_CASE("lines are aligned by their widths", "[unit]") {
    const Font font = dejavu();
    const double wide = advance_of(font, "HH"), narrow = advance_of(font, "H");
    CHECK(lay_out({"HH", "H"}, font, Align::center, 1)[2].x == -narrow / 2);
    CHECK(lay_out({"HH", "H"}, font, Align::center, 1)[0].x == -wide / 2);
    CHECK(lay_out({"HH", "H"}, font, Align::right, 1)[2].x == -narrow);
    CHECK(lay_out({"HH", "H"}, font, Align::right, 1)[0].x == -wide);
}

TEST_CASE("text is shaped: pairs are kerned, and what runs from right to left does", "[unit]") {
    const Font font = dejavu();
    CHECK(lay_out({"AV"}, font, Align::left, 1)[1].x < advance_of(font, "A"));
    const auto hebrew = lay_out({"\u05d0\u05d1"}, font, Align::left, 1);  // alef, then bet to its left
    REQUIRE(hebrew.size() == 2);
    CHECK(hebrew[0].glyph == FT_Get_Char_Index(font.face(), 0x05d1));
    CHECK(hebrew[1].glyph == FT_Get_Char_Index(font.face(), 0x05d0));
}

TEST_CASE("every character that the font lacks is named once", "[unit]") {
    const Font font = dejavu();
    CHECK_THROWS_WITH(
        lay_out({"a\u6f22b", "\u5b57\u6f22"}, font, Align::left, 1),
        font.path() +
            " has no '\u6f22' (U+6F22), '\u5b57' (U+5B57); leave them out, or name a font that has them");
    CHECK_THROWS_WITH(lay_out({"\U0001f437"}, font, Align::left, 1),
                      font.path() + " has no '\U0001f437' (U+1F437); leave it out, or name a font that has it");
}

TEST_CASE("letters that are grown to be bold keep apart by what they grew", "[unit]") {
    const Font font(inscription::find_font("DejaVu Sans", FontWeight::regular), FontWeight::bold);
    REQUIRE(font.growth() == 2048 / 24);
    CHECK(lay_out({"HH"}, font, Align::left, 1)[1].x ==
          advance_of(font, "H") + static_cast<double>(font.growth()));
}
