#include "target_options.hpp"

#include <algorithm>

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
        std::replace(recipe.text->begin(), recipe.text->end(), ' ', '\n');
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

}  // namespace orbweaver::inscription
