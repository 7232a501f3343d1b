#include "target_file.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "baked/baked_writer.hpp"
#include "bitmaps.hpp"
#include "dilate.hpp"
#include "orbweaver/fault.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

BakedFile open(const std::string& path) { return {path, kTargetType, kTargetVersion}; }

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a file holds, right or wrong.
struct Content {
    std::vector<std::uint32_t> record = {16, 20, 7, 1};
    std::vector<std::uint8_t> coverage = test::random_bitmap(16, 20, 0.05, 1).values;
    std::vector<std::uint8_t> dilated = dilate(test::random_bitmap(16, 20, 0.05, 1), 7).values;
};

/// The sentence that it is refused with by `read`, behind the file's name.
template <class Read>
std::string refusal(const Content& content, Read read) {
    const test::Scratch folder;
    std::array<std::uint32_t, 4> record{};
    std::copy(content.record.begin(), content.record.end(), record.begin());
    const std::string recipe = "source: gaps\n";
    BakedWriter writer(kTargetType, kTargetVersion, {});
    writer.add_record("target", record);
    writer.add("coverage", std::span<const std::uint8_t>(content.coverage));
    writer.add("dilated", std::span<const std::uint8_t>(content.dilated));
    writer.add("recipe", std::span<const char>(recipe));
    writer.write(folder.path("f"));
    try {
        read(open(folder.path("f")));
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::invalid);
        return std::string(fault.what()).substr(folder.path("f").size() + 2);
    }
    return "";
}

}  // namespace

TEST_CASE("a target comes back from its file as it was, dilated by 7 x 7", "[unit]") {
    const test::Scratch folder;
    const Bitmap coverage = test::random_bitmap(123, 45, 0.02, 5);
    write_target(folder.path("f"), coverage, {5, 6}, "source: text\ntext: a\n");
    const BakedFile file = open(folder.path("f"));
    const Target target = target_in(file);
    CHECK(target.width == 123);
    CHECK(target.height == 45);
    CHECK(std::equal(target.coverage.begin(), target.coverage.end(), coverage.values.begin(),
                     coverage.values.end()));
    const Bitmap dilated = dilate(coverage, 7);
    CHECK(
        std::equal(target.dilated.begin(), target.dilated.end(), dilated.values.begin(), dilated.values.end()));
    CHECK(target.index(3, 2) == 2 * 123 + 3);
    CHECK(recipe_in(file) == "source: text\ntext: a\n");
    CHECK(builder_in(file) == kTargetBuilder);
    CHECK(file.source_hash() == ContentHash{5, 6});
    CHECK_NOTHROW(verify_target(file));
}

TEST_CASE("a target in which nothing is dark is not written", "[unit]") {
    const test::Scratch folder;
    CHECK_THROWS_WITH(write_target(folder.path("f"), Bitmap(16, 16), {1, 2}, "source: gaps\n"),
                      folder.path("f") +
                          ": nothing in it would be dark; expected something to be inscribed, so name other "
                          "words, another picture or more gaps");
    CHECK_FALSE(std::filesystem::exists(folder.path("f")));
}

TEST_CASE("the same target gives the same bytes", "[unit]") {
    const test::Scratch folder;
    const Bitmap coverage = test::random_bitmap(64, 64, 0.1, 5);
    write_target(folder.path("a"), coverage, {1, 2}, "source: gaps\n");
    write_target(folder.path("b"), coverage, {1, 2}, "source: gaps\n");
    CHECK(bytes_of(folder.path("a")) == bytes_of(folder.path("b")));
}

TEST_CASE("a file whose sections disagree is refused when it is read", "[unit]") {
    const auto read = [](const BakedFile& file) { target_in(file); };
    const std::string again = "; bake it again with orbweaver-assets";
    const std::vector<std::pair<const char*, void (*)(Content&)>> cases = {
        {"it has 15 x 20 pixels; expected sides of 16 to 4096", [](Content& c) { c.record[0] = 15; }},
        {"it has 16 x 4294967295 pixels; expected sides of 16 to 4096", [](Content& c) { c.record[1] = ~0u; }},
        {"it is dilated by 5 pixels; expected 7", [](Content& c) { c.record[2] = 5; }},
        {"coverage has 320 pixels; expected 336", [](Content& c) { c.record[1] = 21; }},
        {"dilated has 319 pixels; expected 320", [](Content& c) { c.dilated.pop_back(); }},
        {"coverage has values other than 0 and 1", [](Content& c) { c.coverage[7] = 2; }},
        {"dilated has values other than 0 and 1", [](Content& c) { c.dilated[319] = 255; }}};
    REQUIRE(refusal({}, read).empty());
    for (const auto& [sentence, spoil] : cases) {
        Content content;
        spoil(content);
        CHECK(refusal(content, read) == "is unsound: " + std::string(sentence) + again);
    }
}

TEST_CASE("a target that reads well and is wrong all the same is told by verifying it", "[unit]") {
    const auto prove = [](const BakedFile& file) { verify_target(file); };
    const std::string again = "; bake it again with orbweaver-assets";
    REQUIRE(refusal({}, prove).empty());
    Content flipped;
    flipped.dilated[16 * 9 + 3] ^= 1;
    CHECK(refusal(flipped, prove) == "is unsound: dilated is wrong at pixel 3, 9" + again);
    Content blank;
    blank.coverage.assign(320, 0);
    CHECK(refusal(blank, prove) == "is unsound: nothing in its coverage is dark" + again);
}

TEST_CASE("a target damaged in any byte, cut or of another type is refused", "[unit]") {
    const test::Scratch folder;
    write_target(folder.path("f"), test::random_bitmap(16, 16, 0.1, 5), {1, 2}, "source: gaps\n");
    const std::string sound = bytes_of(folder.path("f"));
    for (std::size_t i = 0; i < sound.size(); ++i) {
        std::string damaged = sound;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        CHECK_THROWS_AS(open(folder.write("damaged", damaged)), Fault);
    }
    for (std::size_t size = 0; size < sound.size(); size += 7)
        CHECK_THROWS_AS(open(folder.write("cut", sound.substr(0, size))), Fault);
    CHECK_THROWS_WITH(BakedFile(folder.path("f"), "mesh", 1),
                      folder.path("f") + ": holds a target; expected a mesh");
}
