#include "font_files.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "cache_environment.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// A home with fonts of families that exist nowhere else.
class Home {
public:
    Home() {
        const std::string fonts = folder_.path(".local/share/fonts/some");
        std::filesystem::create_directories(fonts);
        for (const char* name :
             {"QwxSans-Bold.ttf", "QwxSans.ttf", "QwxSansMono-Bold.ttf", "QwxSerif-Regular.otf"})
            folder_.write(".local/share/fonts/some/" + std::string(name), "");
        ::setenv("HOME", folder_.path().c_str(), 1);
    }
    std::string font(const std::string& name) const { return folder_.path(".local/share/fonts/some/" + name); }
    const test::Scratch& folder() const { return folder_; }

private:
    test::CacheEnvironment environment_;
    test::Scratch folder_;
};

}  // namespace

TEST_CASE("a family is found by its name, whatever its case and blanks, in the weight that is asked for",
          "[unit]") {
    const Home home;
    CHECK(find_font("Qwx Sans", FontWeight::bold) == home.font("QwxSans-Bold.ttf"));
    CHECK(find_font("qwxsans", FontWeight::regular) == home.font("QwxSans.ttf"));
    CHECK(find_font("Qwx Serif", FontWeight::regular) == home.font("QwxSerif-Regular.otf"));
    CHECK(find_font("Qwx Serif", FontWeight::bold) == home.font("QwxSerif-Regular.otf"));  // it has no bold one
    CHECK(find_font("Qwx Sans Mono", FontWeight::bold) == home.font("QwxSansMono-Bold.ttf"));
}

TEST_CASE("a file is taken as it is", "[unit]") {
    const Home home;
    const std::string file = home.folder().write("mine.bin", "");
    CHECK(find_font(file, FontWeight::bold) == file);
}

TEST_CASE("a font that is not there is told with its remedy", "[unit]") {
    const Home home;
    CHECK_THROWS_WITH(
        find_font("Qwx Nothing", FontWeight::bold),
        "there is no font 'Qwx Nothing' in /usr/share/fonts, /usr/local/share/fonts or "
        "~/.local/share/fonts; install it, or name a font file or another family, such as DejaVu Sans");
    CHECK_THROWS_WITH(find_font("/no/such.ttf", FontWeight::bold),
                      "/no/such.ttf: there is no such font file; correct the path, or name a family");
}

TEST_CASE("the font of targets that name none is installed", "[unit]") {
    CHECK(find_font(kDefaultFont, FontWeight::bold).ends_with("DejaVuSans-Bold.ttf"));
    CHECK(find_font(kDefaultFont, FontWeight::regular).ends_with("DejaVuSans.ttf"));
}
