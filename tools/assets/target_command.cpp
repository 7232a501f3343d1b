#include "target_command.hpp"

#include <fmt/format.h>

#include <map>

#include "bake_target.hpp"
#include "cli/scene_arguments.hpp"
#include "target_file.hpp"
#include "target_report.hpp"

namespace orbweaver {

namespace {

using inscription::Align;
using inscription::FontWeight;
using inscription::TargetRecipe;

const std::map<std::string, FontWeight> kWeights = {{"regular", FontWeight::regular},
                                                    {"bold", FontWeight::bold}};
const std::map<std::string, Align> kAligns = {
    {"left", Align::left}, {"center", Align::center}, {"right", Align::right}};

/// "600" or "600x400".
void parse_size(const std::string& text, TargetRecipe& recipe) {
    const std::size_t cross = text.find('x');
    const auto width = parse_number<std::uint32_t>(text.substr(0, cross));
    const auto height =
        cross == std::string::npos ? width : parse_number<std::uint32_t>(text.substr(cross + 1));
    const auto fits = [](const std::optional<std::uint32_t>& side) {
        return side && *side >= inscription::kSmallestSide && *side <= inscription::kLargestSide;
    };
    if (!fits(width) || !fits(height))
        throw CLI::ValidationError(
            "--size", fmt::format("'{}' is not the size of a target; expected W or WxH, {} to {} pixels", text,
                                  inscription::kSmallestSide, inscription::kLargestSide));
    recipe.width = *width;
    recipe.height = *height;
}

/// CLI::Range lets pass what is no number, and what is none is never out of range.
std::function<std::string(const std::string&)> number_between(double low, double high) {
    return [=](const std::string& text) {
        const auto number = parse_number<double>(text);
        return number && *number >= low && *number <= high
                   ? std::string()
                   : fmt::format("'{}' is not a number from {:g} to {:g}", text, low, high);
    };
}

/// CLI11 takes what is below 0 or too large for another number.
std::string check_seed(const std::string& text) {
    return parse_number<std::uint64_t>(text)
               ? ""
               : fmt::format("'{}' is not a seed; expected a whole number from 0 to 2^64 - 1", text);
}

/// Shells hand over "\n" as two characters.
std::string with_line_breaks(std::string text) {
    for (std::size_t at = text.find("\\n"); at != std::string::npos; at = text.find("\\n", at))
        text.replace(at, 2, "\n");
    return text;
}

}  // namespace

TargetCommand::TargetCommand(CLI::App& app)
    : command_(app.add_subcommand("target", "bake a picture or words, ready to be inscribed into a web")) {
    add_picture_options();
    add_text_options();
    command_->add_option("-o,--output", output_, "the file to write")->required();
    command_->add_option("--size", size_, "pixels of the target, W or WxH; what is in it keeps its proportions")
        ->capture_default_str();
    command_
        ->add_option(
            "--margin", recipe_.margin,
            "left free at each edge, as a share of the shorter side; else 0 of a picture, 0.05 of text")
        ->check(number_between(0.0, 0.45));
    command_
        ->add_option("--gaps", recipe_.gaps,
                     "random gaps that darken this share of all pixels; alone or in addition")
        ->check(number_between(0.0, 0.5))
        ->capture_default_str();
    command_->add_option("--seed", recipe_.seed, "another seed, other gaps")
        ->check(check_seed)
        ->capture_default_str();
}

void TargetCommand::add_picture_options() {
    auto* picture = command_->add_option("IMAGE", recipe_.picture, "the picture: PNG, JPEG or Radiance HDR");
    command_
        ->add_option("--threshold", recipe_.threshold,
                     "what is darker is inscribed, 0 to 1; else Otsu's, which parts the shades best")
        ->check(number_between(0.0, 1.0))
        ->needs(picture);
    command_->add_flag("--invert", recipe_.invert, "inscribe what is bright")->needs(picture);
    command_
        ->add_option("--low-pass", recipe_.low_pass,
                     "blur first: the standard deviation of a Gaussian, pixels of the target")
        ->check(number_between(0.0, 100.0))
        ->needs(picture);
}

void TargetCommand::add_text_options() {
    auto* text = command_->add_option("--text", recipe_.text, "the words, UTF-8; \\n begins a new line")
                     ->excludes(command_->get_option("IMAGE"));
    command_->add_option("--font", recipe_.font, "a font file, or a family that is installed")
        ->needs(text)
        ->capture_default_str();
    command_->add_option("--weight", weight_, "the family's own, else the letters are grown")
        ->check(CLI::IsMember(kWeights))
        ->needs(text)
        ->capture_default_str();
    command_->add_option("--align", align_, "of lines")
        ->check(CLI::IsMember(kAligns))
        ->needs(text)
        ->capture_default_str();
    command_->add_option("--line-spacing", recipe_.line_spacing, "times the font's own")
        ->check(number_between(0.1, 10.0))
        ->needs(text)
        ->capture_default_str();
}

TargetRecipe TargetCommand::recipe() const {
    TargetRecipe recipe = recipe_;
    parse_size(size_, recipe);
    recipe.weight = kWeights.at(weight_);
    recipe.align = kAligns.at(align_);
    if (recipe.text) recipe.text = with_line_breaks(*recipe.text);
    if (!recipe.picture && !recipe.text && recipe.gaps == 0)
        throw CLI::ValidationError("target",
                                   "there is nothing to make one of; expected IMAGE, --text or --gaps");
    return recipe;
}

int TargetCommand::run() const {
    bake_target(recipe(), output_);
    fmt::print("{}", target_text(BakedFile(output_, inscription::kTargetType, inscription::kTargetVersion)));
    return 0;
}

}  // namespace orbweaver
