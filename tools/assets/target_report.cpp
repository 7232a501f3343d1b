#include "target_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "picture/png.hpp"
#include "target_file.hpp"

namespace orbweaver {

namespace {

using namespace inscription;

constexpr std::uint8_t kWhite = 255;
constexpr std::uint8_t kGray = 170;

double share(std::span<const std::uint8_t> pixels) {
    return static_cast<double>(std::count(pixels.begin(), pixels.end(), 1)) /
           static_cast<double>(pixels.size());
}

/// Calls `take` with key and value of each line of a recipe.
template <class Take>
void for_each_entry(std::string_view recipe, Take take) {
    while (!recipe.empty()) {
        const std::string_view line = recipe.substr(0, recipe.find('\n'));
        const std::size_t colon = std::min(line.find(": "), line.size());
        take(line.substr(0, colon), line.substr(std::min(colon + 2, line.size())));
        recipe.remove_prefix(std::min(line.size() + 1, recipe.size()));
    }
}

}  // namespace

std::string target_text(const BakedFile& file) {
    const Target target = target_in(file);
    std::string text = fmt::format(
        "{}: a target, version {}, {} bytes, from source {}\n"
        "  {} x {} pixels, {:.2f} % of them dark, {:.2f} % dilated by {} x {}\n"
        "recipe\n",
        file.path(), kTargetVersion, file.size(), to_string(file.source_hash()), target.width, target.height,
        100 * share(target.coverage), 100 * share(target.dilated), kDilation, kDilation);
    for_each_entry(recipe_in(file), [&](std::string_view key, std::string_view value) {
        text += fmt::format("  {:<14}{}\n", key, value);
    });
    return text;
}

std::string target_json(const BakedFile& file) {
    const Target target = target_in(file);
    nlohmann::ordered_json json = {{"kind", kTargetType},
                                   {"version", kTargetVersion},
                                   {"builder", builder_in(file)},
                                   {"source_hash", to_string(file.source_hash())},
                                   {"bytes", file.size()},
                                   {"width", target.width},
                                   {"height", target.height},
                                   {"dilation", kDilation},
                                   {"dark_share", share(target.coverage)},
                                   {"dilated_share", share(target.dilated)}};
    auto& recipe = json["recipe"] = nlohmann::ordered_json::object();
    for_each_entry(recipe_in(file),
                   [&](std::string_view key, std::string_view value) { recipe[std::string(key)] = value; });
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::vector<std::uint8_t> target_png(const BakedFile& file) {
    const Target target = target_in(file);
    std::vector<std::uint8_t> rgb;
    rgb.reserve(3 * target.coverage.size());
    for (std::size_t i = 0; i < target.coverage.size(); ++i) {
        const std::uint8_t bright = target.dilated[i] != 0 ? kGray : kWhite;
        rgb.insert(rgb.end(), 3, target.coverage[i] != 0 ? std::uint8_t{0} : bright);
    }
    return picture::encode_png(static_cast<int>(target.width), static_cast<int>(target.height), rgb,
                               picture::PngEffort::small);
}

}  // namespace orbweaver
