#include "study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "orbweaver/fault.hpp"
#include "plan/scene_table.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver::study {

namespace {

[[noreturn]] void refuse(const AxisText& axis, const std::string& sentence) {
    throw Fault(FaultKind::invalid, fmt::format("--axis {}: {}", axis.path, sentence));
}

/// The part of `text` before `mark`, which is cut off with it; nothing when there is no mark.
std::optional<std::string> cut(std::string& text, std::string_view mark) {
    const auto at = text.find(mark);
    if (at == std::string::npos) return std::nullopt;
    std::string before = text.substr(0, at);
    text.erase(0, at + mark.size());
    return before;
}

bool is_digits(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

std::span<const OptionSpec> options_of(const AxisText& axis, const std::string& table, const Plan& plan) {
    if (table == "scene") return scene_options();
    std::vector<std::string> tables{"scene"};
    for (const PlannedModule& module : plan.modules) {
        if (module.manifest->table == table) return module.manifest->options;
        if (!module.manifest->table.empty()) tables.push_back(module.manifest->table);
    }
    refuse(axis, fmt::format("the scene has no [{}] that is run; expected an option of {}", table,
                             join_names(tables)));
}

const OptionSpec& number_option(const AxisText& axis, const MapAxis& found,
                                std::span<const OptionSpec> options) {
    std::vector<std::string> numbers;
    for (const OptionSpec& option : options) {
        if (option.type != OptionType::number) continue;
        if (option.key == found.option) return option;
        numbers.push_back(option.key);
    }
    const std::string nearest = nearest_name(found.option, numbers);
    refuse(axis,
           fmt::format("[{}] has no option '{}' that is a number; expected {}{}", found.table, found.option,
                       join_names(numbers), nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

double in_unit(const AxisText& axis, const Quantity& quantity, const OptionSpec& option) {
    if (!quantity.has_unit) return quantity.value;
    const auto unit = parse_unit(option.unit);
    if (!quantity.unit.same_dimension(*unit))
        refuse(axis,
               fmt::format("its ends are not in the option's unit; expected {} or plain numbers", option.unit));
    return convert(quantity, *unit);
}

std::optional<double> own_value(const MapAxis& axis, std::size_t index, const Plan& plan) {
    if (axis.table == "scene" && axis.option == "step") return plan.scene.step;
    if (axis.table == "scene") return plan.scene.duration;
    const std::string instance = index == 0 ? axis.table : fmt::format("{}.{}", axis.table, index + 1);
    for (const PlannedModule& module : plan.modules)
        if (module.instance == instance && module.options.has(axis.option))
            return module.options.number(axis.option);
    return std::nullopt;
}

}  // namespace

std::optional<AxisText> parse_axis(const std::string& text) {
    std::string rest = text;
    AxisText axis;
    const auto path = cut(rest, "=");
    const auto low = cut(rest, "..");
    const auto high = cut(rest, ":");
    const auto count = cut(rest, ":").value_or(rest);
    const std::string spacing = count == rest ? "" : rest;
    if (!path || !low || !high || path->find('.') == std::string::npos) return std::nullopt;
    const auto first = parse_quantity(*low);
    const auto last = parse_quantity(*high);
    if (!first || !last || !is_digits(count) || count.size() > 3) return std::nullopt;
    if (!spacing.empty() && spacing != "lin" && spacing != "log") return std::nullopt;
    axis = {*path, *first, *last, std::stoi(count), std::nullopt};
    if (!spacing.empty()) axis.log = spacing == "log";
    // One unit behind the upper end is meant for both.
    if (!axis.low.has_unit && axis.high.has_unit) {
        axis.low.unit = axis.high.unit;
        axis.low.has_unit = true;
    }
    const double begin = convert(axis.low, Unit{});
    const double end = convert(axis.high, Unit{});
    const bool rises = begin < end && std::isfinite(end - begin);
    if (!rises || axis.count < 2 || axis.count > 200 || (axis.log == true && begin <= 0)) return std::nullopt;
    return axis;
}

std::vector<double> spaced(double low, double high, int count, bool log) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / (count - 1);
        values.push_back(log ? low * std::pow(high / low, part) : low + part * (high - low));
    }
    values.back() = high;
    return values;
}

MapAxis resolve_axis(const AxisText& text, const Plan& plan) {
    MapAxis axis;
    axis.path = text.path;
    axis.option = text.path;
    axis.table = cut(axis.option, ".").value_or("");
    std::size_t index = 0;
    if (std::string rest = axis.option; const auto number = cut(rest, ".")) {
        if (is_digits(*number) && number->size() < 7) {
            index = std::stoul(*number);
            axis.option = rest;
        }
    }
    const OptionSpec& option = number_option(text, axis, options_of(text, axis.table, plan));
    axis.unit = option.unit;
    const double low = in_unit(text, text.low, option);
    const double high = in_unit(text, text.high, option);
    axis.log = text.log.value_or(low > 0);
    axis.values = spaced(low, high, text.count, axis.log);
    axis.own = own_value(axis, index, plan);
    return axis;
}

}  // namespace orbweaver::study
