#include "study/web_pictures.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"
#include "support/painted_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// Pixels of 1 mm, of one block 12 cm wide and 4 cm high. Pixels are seen whose corners lie within margins, of
/// which a quarter of a pixel keeps roundings away.
Photograph one_block() { return {{{{}, {0.06, 0, 0}, {0, 0.02, 0}}}, 0.02025, 0.0039, 0.0010001}; }

int shade(const picture::GrayPicture& picture, int x, int y) {
    return picture.shades[static_cast<std::size_t>(y * picture.width + x)];
}

/// Columns from `left` to before `right` and rows from `top` to before `bottom` are black, all else is white.
void check_square(const picture::GrayPicture& picture, int left, int right, int top, int bottom) {
    std::size_t wrong = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const bool within = x >= left && x < right && y >= top && y < bottom;
            wrong += shade(picture, x, y) != (within ? 0 : 255);
        }
    CHECK(wrong == 0);
}

void check_size(const picture::GrayPicture& picture, int width, int height) {
    CHECK(picture.width == width);
    CHECK(picture.height == height);
    CHECK(picture.shades.size() == static_cast<std::size_t>(width * height));
}

/// Of a Gaussian, up to so many deviations.
double share_below(double deviations) { return 0.5 * std::erfc(-deviations / std::sqrt(2.0)); }

}  // namespace

TEST_CASE("a block is seen with its margin, silk dark, where it stands in the web", "[unit]") {
    const PaintedScene scene("[view]\nmiddles = [[0.0205, 0.0105, 0]]\nhalf = 0.005\n");
    const auto pictures = photograph(scene.run, one_block(), {0});
    REQUIRE(pictures.size() == 1);
    REQUIRE(pictures[0].size() == 1);
    const picture::GrayPicture& plain = pictures[0][0].plain;
    check_size(plain, 160, 80);
    check_square(plain, 80 + 16, 80 + 26, 40 - 15, 40 - 5);
}

TEST_CASE("webs that are turned are seen from their front, along their normal", "[unit]") {
    const Vec3 middle{3, 2, 1}, right{0.8, 0, -0.6}, up{0, 1, 0};
    Photograph how = one_block();
    how.blocks = {{middle, 0.06 * right, 0.02 * up}};
    const Vec3 square = middle + 0.0205 * right + 0.0105 * up;
    const PaintedScene scene(
        fmt::format("[view]\nmiddles = [[{}, {}, {}]]\nhalf = 0.005\n", square.x, square.y, square.z));
    check_square(photograph(scene.run, how, {0})[0][0].plain, 80 + 16, 80 + 26, 40 - 15, 40 - 5);
}

TEST_CASE("each block is a picture of its own, wherever it stands beside the first", "[unit]") {
    // From 10 cm left of the first block's middle to 4 cm right of it, from 24 cm below to 2 cm above: 26 cm
    // and four margins are seen.
    Photograph how = one_block();
    how.blocks = {{{0, 0, 0}, {0.04, 0, 0}, {0, 0.02, 0}}, {{-0.07, -0.22, 0}, {0.03, 0, 0}, {0, 0.02, 0}}};
    const PaintedScene scene("[view]\nmiddles = [[0.0105, 0.0005, 0], [-0.0905, -0.2105, 0]]\nhalf = 0.005\n");
    for (const bool turned_around : {false, true}) {
        if (turned_around) std::swap(how.blocks[0], how.blocks[1]);
        const auto pictures = photograph(scene.run, how, {0})[0];
        REQUIRE(pictures.size() == 2);
        const picture::GrayPicture &first = pictures[turned_around ? 1 : 0].plain,
                                   &second = pictures[turned_around ? 0 : 1].plain;
        check_size(first, 120, 80);
        check_size(second, 100, 80);
        check_square(first, 60 + 6, 60 + 16, 40 - 5, 40 + 5);
        check_square(second, 50 - 25, 50 - 15, 40 - 14, 40 - 4);
    }
}

TEST_CASE("shades are those of light as eyes weigh it, stretched from black to white", "[unit]") {
    const PaintedScene scene(
        "[view]\nhalf = 0.01\nmiddles = [[-0.04, 0, 0], [-0.01, 0, 0], [0.02, 0, 0], [0.05, 0, 0]]\n"
        "colors = [[200, 200, 200], [100, 0, 0], [0, 100, 0], [0, 0, 100]]\n");
    const auto pictures = photograph(scene.run, one_block(), {0});
    const picture::GrayPicture& plain = pictures[0][0].plain;
    CHECK(shade(plain, 80 - 60, 40) == 255);
    CHECK(shade(plain, 80 - 40, 40) == 0);
    CHECK(shade(plain, 80 - 10, 40) == static_cast<int>(255 * (1 - 0.2126 / 2)));
    CHECK(shade(plain, 80 + 20, 40) == static_cast<int>(255 * (1 - 0.7152 / 2)));
    CHECK(shade(plain, 80 + 50, 40) == static_cast<int>(255 * (1 - 0.0722 / 2)));
}

TEST_CASE("a picture in which all is alike is of one shade", "[unit]") {
    const PaintedScene scene("[view]\nmiddles = [[9, 9, 0]]\n");
    const auto shades = photograph(scene.run, one_block(), {0})[0][0].plain.shades;
    CHECK(std::count(shades.begin(), shades.end(), shades[0]) == 160 * 80);
}

TEST_CASE("an edge is blurred as a Gaussian does, and two pixels are left of its deviation", "[unit]") {
    // Silk left of the middle, or above it. A deviation of 3.9 pixels: a pixel of 1.95 is left.
    const bool upright = GENERATE(true, false);
    const PaintedScene scene(
        fmt::format("[view]\nmiddles = [{}]\nhalf = 9\n", upright ? "[-9.0005, 0, 0]" : "[0, 9.0005, 0]"));
    const auto pictures = photograph(scene.run, one_block(), {0});
    check_square(pictures[0][0].plain, 0, upright ? 80 : 160, 0, upright ? 80 : 40);
    const picture::GrayPicture& blurred = pictures[0][0].blurred;
    check_size(blurred, 82, 41);
    for (int y = 0; y < 41; ++y)
        for (int x = 0; x < 82; ++x) {
            const double seen = upright ? std::floor(1.95 * (x + 0.5)) - 80 : std::floor(1.95 * (y + 0.5)) - 40;
            // Shades are rounded down; a sum over pixels is within a quarter of one from the integral.
            CHECK(shade(blurred, x, y) == Approx(255 * share_below((seen + 0.5) / 3.9) - 0.5).margin(0.75));
        }
}

TEST_CASE("a blur of less than two pixels leaves all of them", "[unit]") {
    Photograph how = one_block();
    how.blur = 0.0015;
    const PaintedScene scene("[view]\nmiddles = [[-9.0005, 0, 0]]\nhalf = 9\n");
    const auto pictures = photograph(scene.run, how, {0});
    check_size(pictures[0][0].blurred, 160, 80);
    CHECK(shade(pictures[0][0].blurred, 80, 40) == Approx(255 * share_below(0.5 / 1.5)).margin(2));
}

TEST_CASE("pictures are of the frames nearest to the times asked for", "[unit]") {
    // A millimeter a frame.
    const PaintedScene scene("[view]\nmiddles = [[0.0005, 0.0005, 0]]\nhalf = 0.005\ndrift = [0.01, 0, 0]\n");
    const auto pictures = photograph(scene.run, one_block(), {0, 0.24, 0.26, 0.5});
    REQUIRE(pictures.size() == 4);
    for (const auto& [look, frame] : {std::pair{0, 0}, {1, 2}, {2, 3}, {3, 5}})
        check_square(pictures[static_cast<std::size_t>(look)][0].plain, 76 + frame, 86 + frame, 35, 45);
}

TEST_CASE("a scene that cannot be photographed is told in its own words", "[unit]") {
    const PaintedScene misspelt("[view]\nmiddels = [[0, 0, 0]]\n");
    CHECK_THAT(fault_of([&] { photograph(misspelt.run, one_block(), {0}); }), Catch::Contains("middels"));
    CHECK(kind_of_fault([&] { photograph(misspelt.run, one_block(), {0}); }) == FaultKind::invalid);
    PaintedScene torn("[counter]\n[reader]\nfault = true\n");
    torn.run.module_directories.insert(torn.run.module_directories.end(),
                                       {fixture("counter"), fixture("reader")});
    CHECK_THAT(fault_of([&] { photograph(torn.run, one_block(), {0}); }), Catch::Contains("this page is torn"));
    CHECK(kind_of_fault([&] { photograph(torn.run, one_block(), {0}); }) == FaultKind::invalid);
}

TEST_CASE("a picture larger than a view may be is refused", "[unit]") {
    const PaintedScene scene("[view]\nmiddels = [[0, 0, 0]]\n");  // refused for that where it is not too large
    Photograph how = one_block();
    how.pixel = 0.201 / 8191.5;
    CHECK(kind_of_fault([&] { photograph(scene.run, how, {0}); }) == FaultKind::invalid);
    how.pixel = 0.201 / 8192.5;
    CHECK(kind_of_fault([&] { photograph(scene.run, how, {0}); }) == FaultKind::limit);
    CHECK(fault_of([&] { photograph(scene.run, how, {0}); }) ==
          "a picture in which the web's meshes can be told from each other would be 8193 pixels wide; expected "
          "at most 8192: study a web of fewer turns");
}
