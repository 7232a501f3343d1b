#include "target_picture.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "orbweaver/random.hpp"
#include "picture/decode.hpp"
#include "pictures.hpp"
#include "support/folder.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;
using test::gray_png;

namespace {

std::uint8_t disc(int x, int y) { return (x - 100) * (x - 100) + (y - 80) * (y - 80) < 2500 ? 40 : 220; }

/// A scene of one picture.
struct Stage {
    explicit Stage(const std::string& png) { recipe.picture = folder.write("p.png", png); }
    Bitmap coverage() const { return picture_coverage(recipe); }
    std::string refusal(FaultKind kind = FaultKind::invalid) const {
        try {
            picture_coverage(recipe);
        } catch (const Fault& fault) {
            CHECK(fault.kind() == kind);
            REQUIRE(std::string(fault.what()).starts_with(*recipe.picture + ": "));
            return std::string(fault.what()).substr(recipe.picture->size() + 2);
        }
        return "accepted";
    }

    test::Folder folder;
    TargetRecipe recipe;
};

std::size_t dark(const Bitmap& bitmap) {
    return static_cast<std::size_t>(std::count(bitmap.values.begin(), bitmap.values.end(), 1));
}

}  // namespace

TEST_CASE("a bi-level picture of the target's own size is taken as it is", "[unit]") {
    const RandomStream random(1, "pixels");
    const auto pixel = [&](int x, int y) {
        return static_cast<std::uint8_t>(
            random.uniform(static_cast<std::uint64_t>(y) * 600 + static_cast<std::uint64_t>(x)) < 0.3 ? 0
                                                                                                      : 255);
    };
    const Stage stage(gray_png(600, 600, pixel));
    const Bitmap coverage = stage.coverage();
    bool same = true;
    for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 600; ++x)
            same = same && coverage.row(static_cast<std::uint32_t>(y))[x] == (pixel(x, y) == 0 ? 1 : 0);
    CHECK(same);
}

// A disc of radius 50 in 200 x 160 pixels, three times as large: pi x 150^2 pixels; its rim is 940 pixels long,
// of which interpolation may misplace half a pixel.
TEST_CASE("a picture keeps its proportions and lies in the middle; beside it nothing is inscribed", "[unit]") {
    Stage stage(gray_png(200, 160, disc));
    const Bitmap coverage = stage.coverage();
    CHECK(static_cast<double>(dark(coverage)) == Approx(3.14159265 * 150 * 150).margin(470));
    std::uint32_t left = 600, right = 0, top = 600, bottom = 0;
    for (std::uint32_t y = 0; y < 600; ++y)
        for (std::uint32_t x = 0; x < 600; ++x)
            if (coverage.row(y)[x] != 0) {
                left = std::min(left, x), right = std::max(right, x);
                top = std::min(top, y), bottom = std::max(bottom, y);
            }
    CHECK(std::abs(static_cast<int>(right - left) - static_cast<int>(bottom - top)) <= 2);
    CHECK(left + right == Approx(600).margin(3));
    CHECK(top + bottom == Approx(600).margin(3));
    stage.recipe.invert = true;
    const Bitmap inverted = stage.coverage();
    CHECK(dark(inverted) == std::size_t{600} * 480 - dark(coverage));  // what is beside stays bright
    CHECK(inverted.row(0)[300] == 0);
    CHECK(inverted.row(60)[0] == 1);
}

TEST_CASE("a margin is left free", "[unit]") {
    Stage stage(gray_png(100, 100, [](int x, int) { return static_cast<std::uint8_t>(x < 99 ? 0 : 255); }));
    stage.recipe.margin = 0.1;
    const Bitmap coverage = stage.coverage();
    CHECK(coverage.row(59)[300] == 0);
    CHECK(coverage.row(60)[300] == 1);
    CHECK(coverage.row(300)[59] == 0);
    CHECK(coverage.row(300)[60] == 1);
    CHECK(coverage.row(539)[300] == 1);
    CHECK(coverage.row(540)[300] == 0);
}

TEST_CASE("a threshold parts what is darker from what is not", "[unit]") {
    Stage stage(gray_png(256, 256, [](int x, int) { return static_cast<std::uint8_t>(x); }));
    stage.recipe.width = stage.recipe.height = 256;
    for (const int level : {1, 64, 200, 255}) {
        stage.recipe.threshold = level / 255.0 - 1e-4;
        CHECK(dark(stage.coverage()) == std::size_t{256} * static_cast<std::size_t>(level));
    }
}

TEST_CASE("a low pass takes away what is finer than it", "[unit]") {
    const auto speckled = [](int x, int y) {
        const bool speck = x % 20 == 0 && y % 20 == 0;
        return static_cast<std::uint8_t>(speck != (disc(x, y) < 128) ? 0 : 255);
    };
    Stage stage(gray_png(200, 200, speckled));
    stage.recipe.width = stage.recipe.height = 200;
    CHECK(stage.coverage().row(20)[20] == 1);
    CHECK(stage.coverage().row(80)[100] == 0);
    stage.recipe.low_pass = 3;
    CHECK(stage.coverage().row(20)[20] == 0);
    CHECK(stage.coverage().row(80)[100] == 1);
}

TEST_CASE("a picture in which everything or nothing is dark is refused in words", "[unit]") {
    const std::string one_shade =
        "is of one shade throughout; expected something dark on something bright, so name another picture";
    for (const std::uint8_t shade : {0, 128, 255}) {
        const auto plain = [&](int, int) { return shade; };
        CHECK(Stage(gray_png(50, 40, plain)).refusal() == one_shade);
        CHECK(Stage(gray_png(1, 1, plain)).refusal() == one_shade);
    }
    Stage dot(gray_png(200, 200,
                       [](int x, int y) { return static_cast<std::uint8_t>(x == 99 && y == 99 ? 0 : 255); }));
    CHECK(dot.refusal() == "accepted");
    dot.recipe.low_pass = 100;
    CHECK(dot.refusal() ==
          "is of one shade throughout when it is blurred by 100 pixels; expected something dark on something "
          "bright, so blur it less");
    Stage stage(gray_png(200, 160, disc));
    const std::string rest =
        "; expected something to be inscribed and something not, so name another threshold";
    stage.recipe.threshold = 0.1;
    CHECK(stage.refusal() == "nothing of it is darker than 0.1" + rest);
    stage.recipe.threshold = 0.9;
    CHECK(stage.refusal() == "all of it is darker than 0.9" + rest);
    stage.recipe.invert = true;
    CHECK(stage.refusal() == "nothing of it is brighter than 0.9" + rest);
}

TEST_CASE("a picture of extreme proportions is at least a pixel high", "[unit]") {
    const Stage stage(
        gray_png(20000, 2, [](int x, int) { return static_cast<std::uint8_t>(x < 10000 ? 0 : 255); }));
    CHECK(dark(stage.coverage()) == 300);
}

TEST_CASE("pictures that cannot be had are refused in words, too large ones as a limit", "[unit]") {
    const std::string whole = gray_png(200, 160, disc);
    CHECK(Stage("no picture").refusal().starts_with("the file's first bytes are those of no picture format"));
    CHECK(Stage("").refusal().starts_with("the file is empty"));
    CHECK(Stage(whole.substr(0, whole.size() / 2)).refusal().starts_with("the picture ends too early"));
    std::string vast = whole;
    vast[18] = vast[22] = '\x4e';  // 20,168 pixels wide and 20,128 high
    CHECK(Stage(vast)
              .refusal(FaultKind::limit)
              .starts_with("the picture says it has 20168 x 20128 pixels, more than"));
}
