#include "target_options.hpp"

#include <algorithm>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver::inscription {

namespace {

/// Takes what the scene says; leaves alone what it does not.
class Taker {
public:
    explicit Taker(const Options& options) : options_(options) {}

    void take(const char* key, double& to) const {
        if (options_.has(key)) to = options_.number(key);
    }
    void take(const char* key, std::optional<double>& to) const {
        if (options_.has(key)) to = options_.number(key);
    }
    void take(const char* key, bool& to) const {
        if (options_.has(key)) to = options_.flag(key);
    }
    void take(const char* key, std::string& to) const {
        if (options_.has(key)) to = options_.text(key);
    }
    void take(const char* key, std::optional<std::string>& to) const {
        if (options_.has(key)) to = options_.text(key);
    }

private:
    const Options& options_;
};

/// Each word on a line of its own.
std::string word_by_word(const std::string& text) {
    std::string lines;
    std::size_t end = 0;
    while (true) {
        const std::size_t begin = text.find_first_not_of(" \n", end);
        if (begin == std::string::npos) return lines;
        end = std::min(text.find_first_of(" \n", begin), text.size());
        lines += (lines.empty() ? "" : "\n") + text.substr(begin, end - begin);
    }
}

/// What is inscribed, and which options make a difference to it.
struct Source {
    explicit Source(const Options& options)
        : is_baked(options.has("target") && is_baked_file(options.text("target"))),
          is_picture(options.has("target") && !is_baked),
          is_text(options.has("text")),
          has_gaps(options.has("gaps") && options.number("gaps") > 0),
          mode(options.has("mode") ? options.text("mode") : "") {}

    const char* name() const {
        return is_baked     ? "a target that is baked"
               : is_picture ? "a picture"
               : is_text    ? "words"
                            : "gaps alone";
    }

    bool is_baked, is_picture, is_text, has_gaps;
    std::string mode;
};

/// Options that all want the same.
struct Wish {
    std::vector<const char*> options;
    bool met;
    const char* expected;
};

std::vector<Wish> wishes_to(const Source& source) {
    return {{{"threshold", "invert", "low_pass"}, source.is_picture, "it beside a picture"},
            {{"font", "weight", "align", "line_spacing", "lines"}, source.is_text, "it beside 'text'"},
            {{"margin"}, source.is_picture || source.is_text, "it beside a picture or 'text'"},
            {{"gaps"}, !source.is_baked, "it beside a picture or 'text', or alone"},
            {{"gaps_seed"}, source.has_gaps && !source.is_baked, "it beside 'gaps'"}};
}

}  // namespace

TargetRecipe target_recipe(const Options& options) {
    TargetRecipe recipe;
    const Taker taker(options);
    taker.take("target", recipe.picture);
    taker.take("text", recipe.text);
    taker.take("threshold", recipe.threshold);
    taker.take("invert", recipe.invert);
    taker.take("low_pass", recipe.low_pass);
    taker.take("margin", recipe.margin);
    taker.take("font", recipe.font);
    taker.take("line_spacing", recipe.line_spacing);
    taker.take("gaps", recipe.gaps);
    if (recipe.text && options.has("lines") && options.text("lines") == "words")
        recipe.text = word_by_word(*recipe.text);
    if (options.has("gaps_seed")) recipe.seed = static_cast<std::uint64_t>(options.integer("gaps_seed"));
    if (options.has("resolution"))
        recipe.width = recipe.height = static_cast<std::uint32_t>(options.integer("resolution"));
    if (options.has("weight") && options.text("weight") == "regular") recipe.weight = FontWeight::regular;
    if (options.has("align") && options.text("align") == "left") recipe.align = Align::left;
    if (options.has("align") && options.text("align") == "right") recipe.align = Align::right;
    if (recipe.picture && recipe.text)
        throw Fault(FaultKind::invalid,
                    "both 'target' and 'text' are given; expected one of them, so leave one out");
    if (!recipe.picture && !recipe.text && recipe.gaps == 0)
        throw Fault(FaultKind::invalid, "there is nothing to inscribe; give 'text', 'target' or 'gaps'");
    return recipe;
}

Diagnostics idle_options(const Options& options) {
    const Source source(options);
    Diagnostics faults;
    for (const Wish& wish : wishes_to(source))
        for (const std::string key : wish.options)
            if (!wish.met && options.given(key))
                faults.push_back({options.where(key), "'" + key + "' has no effect on " + source.name(),
                                  wish.expected, "leave it out"});
    for (const std::string key : {"text", "target"})
        if (source.mode == "random_gaps" && !source.is_baked && options.given(key))
            faults.push_back({options.where(key), "mode 'random_gaps' writes no '" + key + "'",
                              "'gaps' alone, or a baked target", "leave it out, or choose mode 'removal'"});
    if (source.mode == "legible" && source.has_gaps)
        faults.push_back({options.where("gaps"), "mode 'legible' writes no gaps", "words or a picture",
                          "choose mode 'random_gaps', or leave 'gaps' out"});
    return faults;
}

}  // namespace orbweaver::inscription
