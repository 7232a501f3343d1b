#include "target_recipe.hpp"

#include <array>
#include <charconv>
#include <filesystem>

#include "baked/content_hash.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

namespace {

/// The shortest digits that give the same number back.
std::string shortest(double value) {
    std::array<char, 32> digits{};
    return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

const char* name_of(Align align) {
    constexpr std::array kNames = {"left", "center", "right"};
    return kNames[static_cast<std::size_t>(align)];
}

class Lines {
public:
    void add(const char* key, const std::string& value) { text_ += std::string(key) + ": " + value + "\n"; }
    void add(const char* key, double value) { add(key, shortest(value)); }
    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

}  // namespace

std::string recipe_text(const TargetRecipe& recipe) {
    Lines lines;
    lines.add("source", recipe.picture ? "picture" : recipe.text ? "text" : "gaps");
    lines.add("size", std::to_string(recipe.width) + " x " + std::to_string(recipe.height));
    if (recipe.picture || recipe.text) lines.add("margin", recipe.margin_or_default());
    if (recipe.picture) {
        lines.add("threshold", recipe.threshold ? shortest(*recipe.threshold) : "otsu");
        lines.add("invert", recipe.invert ? "yes" : "no");
        lines.add("low_pass", recipe.low_pass);
    }
    if (recipe.text) {
        lines.add("text", one_line(*recipe.text));
        const std::filesystem::path font = find_font(recipe.font, recipe.weight);
        lines.add("font", font.filename().string());
        lines.add("weight", recipe.weight == FontWeight::bold ? "bold" : "regular");
        lines.add("align", name_of(recipe.align));
        lines.add("line_spacing", recipe.line_spacing);
    }
    if (recipe.gaps > 0) {
        lines.add("gaps", recipe.gaps);
        lines.add("seed", std::to_string(recipe.seed));
    }
    return lines.take();
}

std::optional<std::string> words_in(std::string_view recipe_text) {
    constexpr std::string_view kKey = "\ntext: ";  // never the first line
    const std::size_t at = recipe_text.find(kKey);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view line = recipe_text.substr(at + kKey.size());
    std::string words;
    for (std::size_t i = 0; i < line.size() && line[i] != '\n'; ++i) {
        const bool escaped = line[i] == '\\' && i + 1 < line.size();
        if (escaped) ++i;
        words += escaped && line[i] == 'n' ? '\n' : line[i];
    }
    return words;
}

std::string one_line(const std::string& text) {
    std::string line;
    for (const char c : text) {
        if (c == '\\' || c == '\n') line += '\\';
        line += c == '\n' ? 'n' : c;
    }
    return line;
}

ContentHash source_hash(const TargetRecipe& recipe) {
    if (recipe.picture) return hash_file(*recipe.picture);
    ContentHasher hasher;
    if (recipe.text) {
        hasher.add(*recipe.text);
        const ContentHash font = hash_file(find_font(recipe.font, recipe.weight));
        hasher.add(&font, sizeof font);
    }
    return hasher.finish();
}

}  // namespace orbweaver::inscription
