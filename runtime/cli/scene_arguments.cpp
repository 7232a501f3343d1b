#include "cli/scene_arguments.hpp"

#include <fmt/format.h>

#include "scene/overrides.hpp"
#include "scene/units.hpp"

namespace orbweaver {

namespace {

bool is_seed(const std::string& text) { return parse_number<std::uint64_t>(text).has_value(); }

// A shorthand for --set scene.KEY=VALUE: numbers stay numbers, everything else is text.
void add_shorthand(RunSettings& settings, const char* key, const std::string& value) {
    if (value.empty()) return;
    const bool bare = value.find_first_not_of("0123456789.+-eE") == std::string::npos;
    settings.overrides.push_back(bare ? fmt::format("scene.{}={}", key, value)
                                      : fmt::format("scene.{}=\"{}\"", key, value));
}

}  // namespace

std::function<std::string(const std::string&)> checked(std::function<bool(const std::string&)> is_right,
                                                       const char* what) {
    return [is_right = std::move(is_right), what](const std::string& text) {
        return is_right(text) ? std::string() : fmt::format("'{}' is not {}", text, what);
    };
}

std::optional<double> parse_seconds(const std::string& text) {
    const auto quantity = parse_quantity(text);
    const auto second = parse_unit("s");
    if (!quantity || (quantity->has_unit && !quantity->unit.same_dimension(*second))) return std::nullopt;
    return quantity->has_unit ? convert(*quantity, *second) : quantity->value;
}

void SceneArguments::add_to(CLI::App& command, RunSettings& settings) {
    command.add_option("SCENE", settings.scene_path, "the scene, a TOML file")->required();
    command
        .add_option("--set", settings.overrides, "override a value of the scene: path.to.key=value; repeatable")
        ->allow_extra_args(false)
        ->check(checked(is_assignment, "an override; expected path.to.key=value"));
    const auto time = checked([](const std::string& text) { return parse_quantity(text).has_value(); },
                              "a time; expected seconds or a text such as \"20 s\"");
    command.add_option("--duration", duration, "how long, in seconds or with a unit (\"20 s\")")->check(time);
    command.add_option("--step", step, "one frame, in seconds or with a unit (\"1/60 s\")")->check(time);
    command.add_option("--seed", seed, "seed of every random stream")
        ->check(checked(is_seed, "a seed; expected a whole number from 0 on"));
    command
        .add_option("--modules", settings.module_directories,
                    "search this folder for modules first; repeatable")
        ->allow_extra_args(false);
}

void SceneArguments::complete(RunSettings& settings) const {
    add_shorthand(settings, "duration", duration);
    add_shorthand(settings, "step", step);
    add_shorthand(settings, "seed", seed);
}

}  // namespace orbweaver
