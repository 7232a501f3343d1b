#include "font.hpp"

#include <freetype/ftbbox.h>

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "support/folder.hpp"

using namespace orbweaver;
using inscription::FontWeight;

namespace {

std::string file(FontWeight weight) { return inscription::find_font("DejaVu Sans", weight); }

FT_Pos width_of(const Font& font, char letter) {
    FT_BBox box{};
    FT_Outline_Get_BBox(&font.outline(FT_Get_Char_Index(font.face(), static_cast<FT_ULong>(letter))), &box);
    return box.xMax - box.xMin;
}

}  // namespace

TEST_CASE("only a font that is not bold is grown to be", "[unit]") {
    CHECK(Font(file(FontWeight::bold), FontWeight::bold).growth() == 0);
    CHECK(Font(file(FontWeight::regular), FontWeight::regular).growth() == 0);
    const Font plain(file(FontWeight::regular), FontWeight::regular),
        grown(file(FontWeight::regular), FontWeight::bold);
    CHECK(grown.growth() == 2048 / 24);
    CHECK(std::abs(width_of(grown, 'I') - width_of(plain, 'I') - grown.growth()) <=
          1);  // a bar: in whole units
}

TEST_CASE("what is no font is refused in words", "[unit]") {
    const test::Folder folder;
    const std::string bad = folder.write("bad.ttf", "not a font");
    CHECK_THROWS_WITH(Font(bad, FontWeight::bold),
                      bad +
                          ": cannot be read as a font (FreeType's error 0x2); name a TrueType or OpenType font "
                          "with outlines");
    const std::string whole = test::read_file(file(FontWeight::bold));
    for (const std::size_t size : {std::size_t{12}, std::size_t{200}, std::size_t{1000}})
        CHECK_THROWS_AS(Font(folder.write("cut.ttf", whole.substr(0, size)), FontWeight::bold), Fault);
}
