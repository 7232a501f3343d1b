#include "study/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "orbweaver/fault.hpp"
#include "plan/scene_table.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver::study {

namespace {

class AxisResolver {
public:
    AxisResolver(const AxisText& text, const Plan& plan) : text_(text), plan_(plan) {}

    MapAxis resolve() {
        axis_.path = text_.path;
        axis_.option = text_.path;
        axis_.table = cut(axis_.option, ".").value_or("");
        // "web.1.drag": of the second [web]
        if (std::string rest = axis_.option; is_digits(cut(rest, ".").value_or(""))) axis_.option = rest;
        const OptionSpec& option = find_option();
        axis_.unit = option.unit;
        if (const auto* range = std::get_if<AxisRange>(&text_.values))
            take_range(*range, option);
        else
            take_list(std::get<AxisList>(text_.values), option);
        if (!axis_.labelled()) axis_.own = own_number();
        return std::move(axis_);
    }

private:
    [[noreturn]] void refuse(const std::string& sentence) const {
        throw Fault(FaultKind::invalid, fmt::format("--axis {}: {}", text_.path, sentence));
    }

    const Manifest* manifest() const {
        for (const PlannedModule& module : plan_.modules)
            if (module.manifest->table == axis_.table) return module.manifest;
        return nullptr;
    }

    const OptionSpec& find_option() const {
        const Manifest* module = axis_.table == "scene" ? nullptr : manifest();
        if (module == nullptr && axis_.table != "scene")
            refuse(fmt::format(
                "the scene has no [{0}] that is run; add one to the scene or by --set {0}.KEY=VALUE, "
                "or vary an option of {1}",
                axis_.table, join_names(tables())));
        std::vector<std::string> names;
        for (const OptionSpec& option : module != nullptr ? module->options : scene_options()) {
            if (option.key == axis_.option) return option;
            names.push_back(option.key);
        }
        const std::string nearest = nearest_name(axis_.option, names);
        refuse(fmt::format("[{}] has no option '{}'; {}{}", axis_.table, axis_.option,
                           nearest.empty() ? "" : "did you mean '" + nearest + "'? ",
                           module != nullptr ? fmt::format("'orbweaver modules {}' lists all", module->id)
                                             : "expected " + join_names(names)));
    }

    std::vector<std::string> tables() const {
        std::set<std::string> names{"scene"};
        for (const PlannedModule& module : plan_.modules)
            if (!module.manifest->table.empty()) names.insert(module.manifest->table);
        return {names.begin(), names.end()};
    }

    static bool is_number(const OptionSpec& option) {
        return option.type == OptionType::number || option.type == OptionType::integer;
    }

    double in_unit(const Quantity& quantity, const OptionSpec& option) const {
        if (!quantity.has_unit) return quantity.value;
        const auto unit = parse_unit(option.unit);
        if (!quantity.unit.same_dimension(*unit))
            refuse(fmt::format("its values are not in the option's unit; expected {} or plain numbers",
                               option.unit));
        return convert(quantity, *unit);
    }

    void take_range(const AxisRange& range, const OptionSpec& option) {
        if (!is_number(option))
            refuse(fmt::format("'{}' is of type {}, which has no range; expected a list of values, A,B,...",
                               option.key, to_string(option.type)));
        const double low = in_unit(range.low, option);
        const double high = in_unit(range.high, option);
        axis_.log = range.log.value_or(low > 0);
        axis_.values = spaced(low, high, range.count, axis_.log);
        if (option.type == OptionType::number) return;
        for (double& value : axis_.values) value = std::round(value);
        axis_.values.erase(std::unique(axis_.values.begin(), axis_.values.end()), axis_.values.end());
        if (axis_.values.size() < 2) refuse("these come to one whole number; expected two or more");
    }

    void take_list(const AxisList& list, const OptionSpec& option) {
        if (is_number(option)) return take_numbers(list, option);
        axis_.labels = list;
        axis_.log = false;
        for (std::size_t i = 0; i < list.size(); ++i) {
            axis_.values.push_back(static_cast<double>(i));
            if (std::count(list.begin(), list.end(), list[i]) > 1) refuse_twice(list[i]);
        }
    }

    void take_numbers(const AxisList& list, const OptionSpec& option) {
        const auto last = parse_quantity(list.back());
        for (const std::string& text : list) {
            auto quantity = parse_quantity(text);
            if (!quantity || !std::isfinite(quantity->value))
                refuse(fmt::format("'{}' is no number; expected numbers{}", text,
                                   option.unit == "1" ? "" : " of " + option.unit));
            // One unit behind the last is meant for all.
            if (!quantity->has_unit && last && last->has_unit) {
                quantity->unit = last->unit;
                quantity->has_unit = true;
            }
            axis_.values.push_back(in_unit(*quantity, option));
        }
        std::sort(axis_.values.begin(), axis_.values.end());
        const auto twice = std::adjacent_find(axis_.values.begin(), axis_.values.end());
        if (twice != axis_.values.end()) refuse_twice(fmt::format("{}", *twice));
        axis_.log = axis_.values.front() > 0;
    }

    [[noreturn]] void refuse_twice(const std::string& value) const {
        refuse(fmt::format("{} is listed twice; name different values", value));
    }

    std::optional<double> own_number() const {
        const auto value = planned_value(axis_, plan_);
        if (!value) return std::nullopt;
        if (const auto* whole = std::get_if<std::int64_t>(&*value)) return static_cast<double>(*whole);
        return std::get<double>(*value);
    }

    const AxisText& text_;
    const Plan& plan_;
    MapAxis axis_;
};

OptionValue scene_value(const std::string& option, const SceneInfo& scene) {
    if (option == "name") return scene.name;
    if (option == "step") return scene.step;
    if (option == "seed") return static_cast<std::int64_t>(scene.seed);
    if (option == "gravity") return scene.gravity;
    return scene.duration;
}

/// The name of the instance that an axis means: the first, or the one it numbers.
std::string instance_of(const MapAxis& axis) {
    std::string rest = axis.path;
    cut(rest, ".");
    const std::string number = cut(rest, ".").value_or("");
    if (!is_digits(number) || number.size() > 6 || std::stoul(number) == 0) return axis.table;
    return fmt::format("{}.{}", axis.table, std::stoul(number) + 1);
}

}  // namespace

std::string MapAxis::text(std::size_t i) const { return labelled() ? labels[i] : fmt::format("{}", values[i]); }

std::vector<double> spaced(double low, double high, int count, bool log) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / (count - 1);
        values.push_back(log ? low * std::pow(high / low, part) : low + part * (high - low));
    }
    values.back() = high;
    return values;
}

std::optional<OptionValue> planned_value(const MapAxis& axis, const Plan& plan) {
    if (axis.table == "scene") return scene_value(axis.option, plan.scene);
    const std::string instance = instance_of(axis);
    for (const PlannedModule& module : plan.modules)
        if (module.instance == instance && module.options.has(axis.option))
            return module.options.entries().find(axis.option)->second.value;
    return std::nullopt;
}

MapAxis resolve_axis(const AxisText& text, const Plan& plan) { return AxisResolver(text, plan).resolve(); }

}  // namespace orbweaver::study
