#include "target_text.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "orbweaver/fault.hpp"

using namespace orbweaver;
using namespace orbweaver::inscription;

namespace {

TargetRecipe recipe_of(const std::string& text) {
    TargetRecipe recipe;
    recipe.text = text;
    return recipe;
}

std::size_t dark(const Bitmap& bitmap) {
    return static_cast<std::size_t>(std::count(bitmap.values.begin(), bitmap.values.end(), 1));
}

/// The smallest rectangle about everything dark, its right and lower ends excluded.
struct Box {
    std::uint32_t left, top, right, bottom;
};

Box box_of(const Bitmap& bitmap, std::uint32_t first_row = 0, std::uint32_t end_row = ~0u) {
    Box box{bitmap.width, bitmap.height, 0, 0};
    for (std::uint32_t y = first_row; y < std::min(end_row, bitmap.height); ++y)
        for (std::uint32_t x = 0; x < bitmap.width; ++x)
            if (bitmap.row(y)[x] != 0)
                box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1), y + 1};
    return box;
}

/// Runs of rows in which something is dark: first row and end of each.
std::vector<std::pair<std::uint32_t, std::uint32_t>> bands(const Bitmap& bitmap) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    for (std::uint32_t y = 0; y < bitmap.height; ++y) {
        if (std::find(bitmap.row(y), bitmap.row(y) + bitmap.width, 1) == bitmap.row(y) + bitmap.width) continue;
        if (found.empty() || found.back().second != y) found.emplace_back(y, y);
        found.back().second = y + 1;
    }
    return found;
}

/// Runs of dark pixels in a row.
std::size_t bars_in_row(const Bitmap& bitmap, std::uint32_t y) {
    std::size_t count = 0;
    for (std::uint32_t x = 0; x < bitmap.width; ++x)
        count += bitmap.row(y)[x] != 0 && (x == 0 || bitmap.row(y)[x - 1] == 0) ? 1 : 0;
    return count;
}

std::string refusal(const TargetRecipe& recipe, FaultKind kind) {
    try {
        text_coverage(recipe);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == kind);
        return fault.what();
    }
    return "accepted";
}

}  // namespace

TEST_CASE("an I is one solid bar that reaches from margin to margin, in the middle", "[unit]") {
    TargetRecipe recipe = recipe_of("I");
    recipe.margin = 0.1;
    const Bitmap coverage = text_coverage(recipe);
    const Box box = box_of(coverage);
    CHECK(box.top == 60);
    CHECK(box.bottom == 540);
    CHECK(box.left + box.right == 600);
    CHECK(dark(coverage) == std::size_t{box.right - box.left} * (box.bottom - box.top));
}

TEST_CASE("letters are where and as many as they should be: an H has two posts and a bar", "[unit]") {
    const Bitmap coverage = text_coverage(recipe_of("H"));
    const Box box = box_of(coverage);
    const std::uint32_t height = box.bottom - box.top;
    CHECK(bars_in_row(coverage, box.top + height / 4) == 2);
    CHECK(bars_in_row(coverage, box.top + height / 2) == 1);
    CHECK(bars_in_row(coverage, box.top + 3 * height / 4) == 2);
}

TEST_CASE("every line is a band of its own", "[unit]") {
    CHECK(bands(text_coverage(recipe_of("SOME PIG"))).size() == 1);
    CHECK(bands(text_coverage(recipe_of("SOME\nPIG"))).size() == 2);
    CHECK(bands(text_coverage(recipe_of("A\nB\nC\nD"))).size() == 4);
}

TEST_CASE("line spacing moves lines apart as it says", "[unit]") {
    const auto pitch = [](double spacing) {
        TargetRecipe recipe = recipe_of("I\nI");
        recipe.line_spacing = spacing;
        const auto found = bands(text_coverage(recipe));
        REQUIRE(found.size() == 2);
        // In heights of the letter, whatever scale both came out at.
        return (found[1].first - found[0].first) / static_cast<double>(found[0].second - found[0].first);
    };
    CHECK(pitch(2) / pitch(1) == Approx(2).epsilon(0.02));  // a pixel of 100 or more
}

TEST_CASE("lines are aligned left, in the middle or right", "[unit]") {
    const auto boxes = [](Align align) {
        TargetRecipe recipe = recipe_of("IIIII\nI");
        recipe.align = align;
        const Bitmap coverage = text_coverage(recipe);
        const auto found = bands(coverage);
        REQUIRE(found.size() == 2);
        return std::pair(box_of(coverage, found[0].first, found[0].second),
                         box_of(coverage, found[1].first, found[1].second));
    };
    const auto [left_long, left_short] = boxes(Align::left);
    CHECK(std::abs(static_cast<int>(left_long.left - left_short.left)) <= 1);
    const auto [right_long, right_short] = boxes(Align::right);
    CHECK(std::abs(static_cast<int>(right_long.right - right_short.right)) <= 1);
    const auto [mid_long, mid_short] = boxes(Align::center);
    CHECK(std::abs(static_cast<int>(mid_long.left + mid_long.right - mid_short.left - mid_short.right)) <= 2);
}

TEST_CASE("text fits its target with its margins, whatever the proportions of both", "[unit]") {
    for (const char* text : {"SOME PIG", "I", "A\nB\nC\nD\nE", "g\u00c5"})
        for (const auto& [width, height] :
             {std::pair(600u, 600u), std::pair(800u, 200u), std::pair(200u, 800u)}) {
            TargetRecipe recipe = recipe_of(text);
            recipe.width = width;
            recipe.height = height;
            const Box box = box_of(text_coverage(recipe));
            const auto margin = static_cast<std::uint32_t>(0.05 * std::min(width, height));
            CHECK(box.left >= margin);
            CHECK(box.top >= margin);
            CHECK(box.right <= width - margin);
            CHECK(box.bottom <= height - margin);
            const bool fills_width = box.right - box.left + 2 >= width - 2 * margin;
            const bool fills_height = box.bottom - box.top + 2 >= height - 2 * margin;
            CHECK((fills_width || fills_height));
        }
}

TEST_CASE("bold is darker than regular, and grown letters are darker than those of the file", "[unit]") {
    TargetRecipe regular = recipe_of("SOME PIG");
    regular.weight = FontWeight::regular;
    const std::size_t thin = dark(text_coverage(regular));
    CHECK(dark(text_coverage(recipe_of("SOME PIG"))) > thin * 5 / 4);
    TargetRecipe grown = recipe_of("SOME PIG");
    grown.font = find_font("DejaVu Sans", FontWeight::regular);  // a file: no other weight is looked for
    CHECK(dark(text_coverage(grown)) > thin * 5 / 4);
}

TEST_CASE("text without ink and text too long are refused in words", "[unit]") {
    CHECK(refusal(recipe_of("\u00a0"), FaultKind::invalid) ==
          "the text has nothing to draw; name words, such as \"SOME PIG\"");
    const std::string sentence = refusal(recipe_of(std::string(200, 'm')), FaultKind::limit);
    CHECK(sentence.starts_with("the text's letters would be "));
    CHECK(sentence.ends_with(
        " pixels high (1 em); expected at least 12: fewer words, more lines, or a larger target"));
}
