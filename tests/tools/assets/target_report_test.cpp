#include "target_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "picture/decode.hpp"
#include "support/folder.hpp"
#include "target_file.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

/// One dark pixel in the middle of 20 x 25.
class OnePixel {
public:
    OnePixel() {
        Bitmap coverage(20, 25);
        coverage.row(12)[10] = 1;
        write_target(folder_.path("f"), coverage, {1, 2}, "source: text\ntext: a: b\\nc\n");
    }
    BakedFile open() const { return {folder_.path("f"), kTargetType, kTargetVersion}; }
    const test::Folder& folder() const { return folder_; }

private:
    test::Folder folder_;
};

}  // namespace

TEST_CASE("a target is told in words", "[unit]") {
    const OnePixel target;
    const BakedFile file = target.open();
    CHECK(target_text(file) == file.path() + ": a target, version 1, " + std::to_string(file.size()) +
                                   " bytes, from source 00000000000000010000000000000002\n"
                                   "  20 x 25 pixels, 0.20 % of them dark, 9.80 % dilated by 7 x 7\n"
                                   "recipe\n"
                                   "  source        text\n"
                                   "  text          a: b\\nc\n");
}

TEST_CASE("a target is told to programs", "[unit]") {
    const OnePixel target;
    const auto json = nlohmann::json::parse(target_json(target.open()));
    CHECK(json["kind"] == "target");
    CHECK(json["version"] == kTargetVersion);
    CHECK(json["builder"] == kTargetBuilder);
    CHECK(json["source_hash"] == "00000000000000010000000000000002");
    CHECK(json["width"] == 20);
    CHECK(json["height"] == 25);
    CHECK(json["dilation"] == 7);
    CHECK(json["dark_share"] == 0.002);
    CHECK(json["dilated_share"] == 0.098);
    CHECK(json["recipe"] == nlohmann::json{{"source", "text"}, {"text", "a: b\\nc"}});
}

TEST_CASE("a target is drawn: coverage black, what dilation adds gray", "[unit]") {
    const OnePixel target;
    const auto png = target_png(target.open());
    const auto picture = picture::decode_gray(
        target.folder().write("p.png", {reinterpret_cast<const char*>(png.data()), png.size()}));
    REQUIRE(picture.width == 20);
    REQUIRE(picture.height == 25);
    auto shade = picture.shades.begin();
    for (int y = 0; y < 25; ++y)
        for (int x = 0; x < 20; ++x) {
            const bool within = std::abs(x - 10) <= 3 && std::abs(y - 12) <= 3;
            const int around = within ? 170 : 255;
            CHECK(*shade++ == (x == 10 && y == 12 ? 0 : around));
        }
}
