#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <functional>
#include <optional>
#include <string>

#include "run/run_scene.hpp"

namespace orbweaver {

/// What is typed must be right, also when it is nothing: "'x' is not a size; ..." where `what` is "a size;
/// ...".
std::function<std::string(const std::string&)> checked(std::function<bool(const std::string&)> is_right,
                                                       const char* what);

template <class Number>
std::optional<Number> parse_number(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && rest == end ? std::optional(number) : std::nullopt;
}

/// A time as typed in seconds, "20 s" or "20"; nothing when it is none.
std::optional<double> parse_seconds(const std::string& text);

/// The arguments that every command on a scene takes, as typed.
struct SceneArguments {
    std::string duration;
    std::string step;
    std::string seed;

    /// SCENE, --set, --duration, --step, --seed and --modules.
    void add_to(CLI::App& command, RunSettings& settings);
    /// Duration, step and seed become overrides.
    void complete(RunSettings& settings) const;
};

}  // namespace orbweaver
