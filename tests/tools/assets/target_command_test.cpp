#include "target_command.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "pictures.hpp"
#include "support/program.hpp"

using namespace orbweaver;
using test::run_assets;

TEST_CASE("from words to a baked target that is inspected, drawn and proved sound", "[unit]") {
    const test::Folder folder;
    const std::string baked = folder.path("made/pig.baked"), png = folder.path("pig.png");
    const auto made = run_assets({"target", "--text", "SOME\\nPIG", "-o", baked, "--size", "300x200", "--align",
                                  "left", "--weight", "regular", "--line-spacing", "0.8", "--margin", "0.1"});
    REQUIRE(made.code == 0);
    CHECK(made.err.empty());
    CHECK(run_assets({"inspect", baked}).out == made.out);
    const auto json = nlohmann::json::parse(run_assets({"inspect", baked, "--json"}).out);
    CHECK(json["width"] == 300);
    CHECK(json["height"] == 200);
    CHECK(json["recipe"] == nlohmann::json{{"source", "text"},
                                           {"size", "300 x 200"},
                                           {"margin", "0.1"},
                                           {"text", "SOME\\nPIG"},
                                           {"font", "DejaVuSans.ttf"},
                                           {"weight", "regular"},
                                           {"align", "left"},
                                           {"line_spacing", "0.8"}});
    CHECK(run_assets({"verify", baked}).out == baked + ": sound\n");
    REQUIRE(run_assets({"inspect", baked, "--png", png}).code == 0);

    // Drawn and read again, with what dilation added above the threshold, it is the same target.
    const std::string again = folder.path("again.baked");
    REQUIRE(run_assets({"target", png, "-o", again, "--threshold", "0.5", "--size", "300x200"}).code == 0);
    const auto copy = nlohmann::json::parse(run_assets({"inspect", again, "--json"}).out);
    CHECK(copy["dark_share"] == json["dark_share"]);
    CHECK(copy["recipe"]["threshold"] == "0.5");
}

TEST_CASE("options of pictures and gaps reach the recipe", "[unit]") {
    const test::Folder folder;
    const std::string png =
        folder.write("p.png", test::gray_png(60, 60, [](int x, int) { return x < 30 ? 0 : 255; }));
    const std::string baked = folder.path("p.baked");
    REQUIRE(
        run_assets({"target", png, "-o", baked, "--invert", "--low-pass", "2", "--gaps", "0.01", "--seed", "9"})
            .code == 0);
    const auto json = nlohmann::json::parse(run_assets({"inspect", baked, "--json"}).out);
    CHECK(json["recipe"] == nlohmann::json{{"source", "picture"},
                                           {"size", "600 x 600"},
                                           {"margin", "0"},
                                           {"threshold", "otsu"},
                                           {"invert", "yes"},
                                           {"low_pass", "2"},
                                           {"gaps", "0.01"},
                                           {"seed", "9"}});
    CHECK(run_assets({"target", "--gaps", "0.1", "-o", baked}).code == 0);
}

TEST_CASE("what is wrong with words or a picture is a sentence and exit code 3, what is too much exit code 5",
          "[unit]") {
    const test::Folder folder;
    const std::string out = folder.path("t.baked");
    const auto white = [](int, int) { return std::uint8_t{255}; };
    std::string vast = test::gray_png(8, 8, white);
    vast[17] = vast[21] = '\x01';  // 65,544 pixels wide and high
    const std::vector<std::pair<int, std::vector<std::string>>> cases = {
        {3, {"--text", ""}},
        {3, {"--text", "\\n"}},
        {3, {"--text", "a\tb"}},
        {3, {"--text", "\u6f22"}},
        {3, {"--text", "a", "--font", "No Such Family"}},
        {3, {"--text", "a", "--font", folder.write("bad.ttf", "bad")}},
        {5, {"--text", std::string(5000, 'x')}},
        {5, {"--text", std::string(500, 'x')}},
        {3, {folder.path("none.png")}},
        {3, {folder.path()}},
        {3, {folder.write("text.png", "not a picture")}},
        {3, {folder.write("blank.png", test::gray_png(8, 8, white))}},
        {3, {folder.write("dot.png", test::gray_png(1, 1, white))}},
        {3, {folder.write("cut.png", test::gray_png(8, 8, white).substr(0, 60))}},
        {5, {folder.write("vast.png", vast)}}};
    for (const auto& [code, words] : cases) {
        std::vector<std::string> arguments = {"target", "-o", out};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const auto outcome = run_assets(arguments);
        INFO(outcome.err);
        CHECK(outcome.code == code);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.starts_with("error: "));
    }
    CHECK_FALSE(std::filesystem::exists(out));
}

TEST_CASE("a wrong command line of a target is exit code 2", "[unit]") {
    struct Case {
        std::vector<std::string> words;
        const char* sentence;
    };
    for (const auto& [words, sentence] : std::vector<Case>{
             {{"-o", "x"}, "there is nothing to make one of"},
             {{"--text", "a"}, "--output is required"},
             {{"p.png", "--text", "a", "-o", "x"}, "IMAGE excludes --text"},
             {{"--text", "a", "-o", "x", "--invert"}, "--invert requires IMAGE"},
             {{"p.png", "-o", "x", "--align", "left"}, "--align requires --text"},
             {{"p.png", "-o", "x", "--threshold", "1.5"}, "--threshold: '1.5' is not a number from 0 to 1"},
             {{"p.png", "-o", "x", "--threshold", "nan"}, "--threshold: 'nan' is not a number from 0 to 1"},
             {{"p.png", "-o", "x", "--low-pass", "-1"}, "--low-pass: '-1' is not a number from 0 to 100"},
             {{"p.png", "-o", "x", "--low-pass", "100.1"}, "--low-pass: '100.1' is not a number from 0 to 100"},
             {{"p.png", "-o", "x", "--low-pass", "NaN"}, "--low-pass: 'NaN' is not a number from 0 to 100"},
             {{"p.png", "-o", "x", "--low-pass", "a lot"}, "--low-pass: 'a lot' is not a number from 0 to 100"},
             {{"p.png", "-o", "x", "--margin", "0.5"}, "--margin: '0.5' is not a number from 0 to 0.45"},
             {{"p.png", "-o", "x", "--margin", "-nan"}, "--margin: '-nan' is not a number from 0 to 0.45"},
             {{"p.png", "-o", "x", "--size", "15"}, "'15' is not the size of a target"},
             {{"p.png", "-o", "x", "--size", "600x"}, "'600x' is not the size of a target"},
             {{"p.png", "-o", "x", "--size", "600x5000"}, "'600x5000' is not the size of a target"},
             {{"--text", "a", "-o", "x", "--weight", "heavy"}, "--weight: "},
             {{"--text", "a", "-o", "x", "--align", "top"}, "--align: "},
             {{"--text", "a", "-o", "x", "--line-spacing", "0.09"},
              "--line-spacing: '0.09' is not a number from 0.1 to 10"},
             {{"--text", "a", "-o", "x", "--line-spacing", "nan"},
              "--line-spacing: 'nan' is not a number from 0.1 to 10"},
             {{"--gaps", "0.6", "-o", "x"}, "--gaps: '0.6' is not a number from 0 to 0.5"},
             {{"--gaps", "nan", "-o", "x"}, "--gaps: 'nan' is not a number from 0 to 0.5"},
             {{"--gaps", "0.1", "-o", "x", "--seed", "-1"}, "--seed: '-1' is not a seed"},
             {{"--gaps", "0.1", "-o", "x", "--seed", "99999999999999999999"},
              "--seed: '99999999999999999999' is not a seed; expected a whole number from 0 to 2^64 - 1"}}) {
        std::vector<std::string> arguments = {"target"};
        arguments.insert(arguments.end(), words.begin(), words.end());
        const auto outcome = run_assets(arguments);
        CAPTURE(words);
        CHECK(outcome.code == 2);
        CHECK_THAT(outcome.err + outcome.out, Catch::Contains(sentence));
    }
    CHECK_FALSE(std::filesystem::exists("x"));
}
