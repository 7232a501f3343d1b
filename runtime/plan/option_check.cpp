#include "plan/option_check.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "orbweaver/fault.hpp"
#include "scene/nearest_name.hpp"
#include "scene/toml_reader.hpp"
#include "scene/units.hpp"

namespace orbweaver {

namespace {

namespace fs = std::filesystem;

/// Turns nodes into checked values of one option.
class ValueReader {
public:
    ValueReader(const OptionSpec& spec, const AssetPaths& paths, Diagnostics& faults)
        : spec_(spec), paths_(paths), faults_(faults) {}

    std::optional<OptionValue> read(const Node& node) const {
        switch (spec_.type) {
            case OptionType::boolean:
                if (const bool* flag = std::get_if<bool>(&node.value)) return *flag;
                return wrong(node, "true or false");
            case OptionType::integer:
                return read_integer(node);
            case OptionType::number:
                return widen(read_number(node));
            case OptionType::text:
            case OptionType::preset:
            case OptionType::named:
                if (const auto* text = std::get_if<std::string>(&node.value)) return *text;
                return wrong(node, "a text");
            case OptionType::choice:
                return read_choice(node);
            case OptionType::vector:
                return widen(read_vector(node));
            case OptionType::vectors:
                return read_list<Vec3>(node, "an array of [x, y, z]",
                                       [&](const Node& n) { return read_vector(n); });
            case OptionType::numbers:
                return read_list<double>(node, "an array of numbers",
                                         [&](const Node& n) { return read_number(n); });
            case OptionType::file:
                return read_file(node);
        }
        return std::nullopt;
    }

private:
    template <class T>
    static std::optional<OptionValue> widen(std::optional<T> value) {
        if (!value) return std::nullopt;
        return OptionValue(*value);
    }

    std::nullopt_t wrong(const Node& node, const std::string& expected) const {
        faults_.push_back({node.where, fmt::format("'{}' is {}", spec_.key, show(node)), expected, ""});
        return std::nullopt;
    }

    std::string expected_number() const {
        std::string text = spec_.unit == "1"
                               ? "a number"
                               : fmt::format("a number of {0}, or a text such as \"1 {0}\"", spec_.unit);
        if (const std::string range = range_text(spec_); !range.empty()) text += ", " + range;
        return text;
    }

    bool in_range(double value) const {
        return (spec_.above_min ? value > spec_.min : value >= spec_.min) &&
               (spec_.below_max ? value < spec_.max : value <= spec_.max);
    }

    std::optional<OptionValue> read_integer(const Node& node) const {
        const auto* value = std::get_if<std::int64_t>(&node.value);
        if (value != nullptr && in_range(static_cast<double>(*value))) return *value;
        std::string expected = "an integer";
        if (const std::string range = range_text(spec_); !range.empty()) expected += " " + range;
        return wrong(node, expected);
    }

    std::optional<double> read_number(const Node& node) const {
        double value = 0;
        if (const auto* number = std::get_if<double>(&node.value))
            value = *number;
        else if (const auto* integer = std::get_if<std::int64_t>(&node.value))
            value = static_cast<double>(*integer);
        else if (const auto* text = std::get_if<std::string>(&node.value)) {
            const auto quantity = parse_quantity(*text);
            const auto unit = parse_unit(spec_.unit);
            if (!quantity || !unit) return wrong(node, expected_number());
            if (quantity->has_unit && !quantity->unit.same_dimension(*unit)) {
                faults_.push_back({node.where,
                                   fmt::format("'{}' is {}, which is not a quantity of {}", spec_.key,
                                               show(node), spec_.unit == "1" ? "no unit" : spec_.unit),
                                   expected_number(), ""});
                return std::nullopt;
            }
            value = quantity->has_unit ? convert(*quantity, *unit) : quantity->value;
        } else {
            return wrong(node, expected_number());
        }
        if (!std::isfinite(value) || !in_range(value))
            return wrong(node, expected_number() + (std::isfinite(value) ? "" : ", finite"));
        return value;
    }

    std::optional<OptionValue> read_choice(const Node& node) const {
        const std::string expected = "one of " + join_names(spec_.choices);
        const auto* text = std::get_if<std::string>(&node.value);
        if (text == nullptr) return wrong(node, expected);
        if (std::find(spec_.choices.begin(), spec_.choices.end(), *text) != spec_.choices.end()) return *text;
        const std::string nearest = nearest_name(*text, spec_.choices);
        faults_.push_back({node.where, fmt::format("'{}' is {}", spec_.key, show(node)), expected,
                           nearest.empty() ? "" : fmt::format("did you mean \"{}\"?", nearest)});
        return std::nullopt;
    }

    std::optional<Vec3> read_vector(const Node& node) const {
        const Array* array = node.array();
        if (array == nullptr || array->size() != 3) {
            wrong(node, "[x, y, z]");
            return std::nullopt;
        }
        const auto x = read_number((*array)[0]);
        const auto y = read_number((*array)[1]);
        const auto z = read_number((*array)[2]);
        if (!x || !y || !z) return std::nullopt;
        return Vec3{*x, *y, *z};
    }

    template <class T, class Read>
    std::optional<OptionValue> read_list(const Node& node, const char* expected, Read&& read_one) const {
        const Array* array = node.array();
        if (array == nullptr) return wrong(node, expected);
        if (spec_.length != 0 && array->size() != spec_.length)
            return wrong(node, fmt::format("an array of {}", spec_.length));
        std::vector<T> values;
        values.reserve(array->size());
        for (const Node& element : *array) {
            const auto value = read_one(element);
            if (!value) return std::nullopt;
            values.push_back(*value);
        }
        return values;
    }

    std::optional<OptionValue> read_file(const Node& node) const {
        const auto* text = std::get_if<std::string>(&node.value);
        if (text == nullptr || text->empty() || text->find('\0') != std::string::npos)
            return wrong(node, "the path of a file");
        const fs::path path = fs::path(paths_.scene_directory) / *text;
        std::error_code error;
        if (!fs::is_regular_file(path, error)) {
            faults_.push_back(
                {node.where,
                 fmt::format("'{}' is {}, and {}", spec_.key, show(node),
                             fs::exists(path, error) ? "that is not a regular file" : "there is no such file"),
                 "a file, its path starting at the scene's folder",
                 fmt::format("looked at {}", path.lexically_normal().string())});
            return std::nullopt;
        }
        if (::access(path.c_str(), R_OK) != 0) {
            faults_.push_back({node.where,
                               fmt::format("'{}' is {}, which may not be read", spec_.key, show(node)),
                               "a readable file",
                               fmt::format("see the permissions of {}", path.lexically_normal().string())});
            return std::nullopt;
        }
        return fs::absolute(path).lexically_normal().string();
    }

    const OptionSpec& spec_;
    const AssetPaths& paths_;
    Diagnostics& faults_;
};

class TableChecker {
public:
    TableChecker(std::span<const OptionSpec> specs, const AssetPaths& paths, Diagnostics& faults)
        : specs_(specs), paths_(paths), faults_(faults) {}

    /// `prefix`: of the keys of this table's options; `pattern`: the same as the manifest has it, where *
    /// stands for a name of the scene's own.
    void read(const Node& table, const std::string& prefix, const std::string& pattern, Options& into) const {
        for (const Member& member : *table.table()) {
            const std::string key = prefix + member.key;
            const std::string known = pattern + (is_known(pattern + member.key) ? member.key : "*");
            if (const OptionSpec* spec = find_spec(known)) {
                OptionSpec named = *spec;
                named.key = key;
                if (auto value = ValueReader(named, paths_, faults_).read(member.node))
                    into.set(key, std::move(*value), member.node.where);
            } else if (!is_group(known)) {
                report_unknown(member, key, pattern);
            } else if (member.node.table() != nullptr) {
                read(member.node, key + ".", known + ".", into);
            } else if (member.node.array() != nullptr && is_known(known + ".*")) {
                read(numbered(member.node), key + ".", known + ".", into);
            } else {
                faults_.push_back(
                    {member.node.where, fmt::format("'{}' is {}", key, show(member.node)), "a table", ""});
            }
        }
    }

    void read_presets(const Options& given, Options& into) const {
        for (const OptionSpec& spec : specs_) {
            if (spec.type != OptionType::preset || !given.has(spec.key)) continue;
            const std::string& name = given.text(spec.key);
            const std::string path = find_named(spec, name);
            if (path.empty()) {
                report_missing_named(spec, name, given.where(spec.key));
                continue;
            }
            try {
                read(read_toml_file(path), "", "", into);
            } catch (const Fault& fault) {
                faults_.push_back({given.where(spec.key), fault.what(), "", ""});
            }
        }
    }

    /// Names become paths.
    void find_named_files(Options& into) const {
        for (const OptionSpec& spec : specs_) {
            if (spec.type != OptionType::named || !into.has(spec.key)) continue;
            const std::string name = into.text(spec.key);
            const Location where = into.given(spec.key) ? into.where(spec.key) : Location{};
            const std::string path = find_named(spec, name);
            if (path.empty())
                report_missing_named(spec, name, into.where(spec.key));
            else
                into.set(spec.key, path, where);
        }
    }

    void add_defaults(Options& into, const Location& table) const {
        for (const OptionSpec& spec : specs_) {
            if (into.has(spec.key)) continue;
            if (spec.required) {
                faults_.push_back({table, fmt::format("'{}' is missing", spec.key), spec.meaning, ""});
            } else if (spec.default_value) {
                if (auto value = ValueReader(spec, paths_, faults_).read(*spec.default_value))
                    into.set(spec.key, std::move(*value), {});
            }
        }
    }

private:
    /// An array of tables as a table whose names are their numbers.
    static Node numbered(const Node& array) {
        Table table;
        for (const Node& element : *array.array())
            table.push_back({std::to_string(table.size()), element.where, element});
        return {std::move(table), array.where};
    }
    const OptionSpec* find_spec(const std::string& key) const {
        const auto found =
            std::find_if(specs_.begin(), specs_.end(), [&](const OptionSpec& s) { return s.key == key; });
        return found == specs_.end() ? nullptr : &*found;
    }
    bool is_group(const std::string& key) const {
        return std::any_of(specs_.begin(), specs_.end(),
                           [&](const OptionSpec& s) { return s.key.starts_with(key + "."); });
    }
    bool is_known(const std::string& key) const { return find_spec(key) != nullptr || is_group(key); }
    void report_unknown(const Member& member, const std::string& key, const std::string& pattern) const {
        std::vector<std::string> names;
        for (const OptionSpec& spec : specs_) {
            if (!spec.key.starts_with(pattern)) continue;
            std::string name = spec.key.substr(pattern.size());
            name = name.substr(0, name.find('.'));
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
        }
        const std::string nearest = nearest_name(member.key, names);
        faults_.push_back(
            {member.where, fmt::format("there is no option '{}'", key), "one of " + join_names(names),
             nearest.empty() ? ""
                             : fmt::format("did you mean '{}{}'?",
                                           key.substr(0, key.size() - member.key.size()), nearest)});
    }
    std::string find_named(const OptionSpec& spec, const std::string& name) const {
        std::error_code error;
        if (name.ends_with(".toml")) {
            const fs::path path = fs::path(paths_.scene_directory) / name;
            return fs::is_regular_file(path, error) ? path.lexically_normal().string() : "";
        }
        for (const std::string& assets : paths_.asset_directories) {
            const fs::path path = fs::path(assets) / spec.folder / (name + ".toml");
            if (fs::is_regular_file(path, error)) return path.lexically_normal().string();
        }
        return "";
    }
    void report_missing_named(const OptionSpec& spec, const std::string& name, const Location& where) const {
        std::vector<std::string> names;
        std::error_code error;
        for (const std::string& assets : paths_.asset_directories)
            for (const auto& entry : fs::directory_iterator(fs::path(assets) / spec.folder, error))
                if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());  // in several folders
        const std::string nearest = nearest_name(name, names);
        faults_.push_back({where, fmt::format("there is no {} '{}'", spec.key, name),
                           (names.empty() ? "" : join_names(names) + ", or ") + "a path ending in .toml",
                           nearest.empty() ? "" : fmt::format("did you mean \"{}\"?", nearest)});
    }

    std::span<const OptionSpec> specs_;
    const AssetPaths& paths_;
    Diagnostics& faults_;
};

}  // namespace

Options check_options(const Node& table, std::span<const OptionSpec> specs, const AssetPaths& paths,
                      Diagnostics& faults) {
    Options result;
    result.set_table(table.where);
    if (table.table() == nullptr) {
        faults.push_back({table.where, fmt::format("this is {}", show(table)), "a table", ""});
        return result;
    }
    const TableChecker checker(specs, paths, faults);
    checker.read(table, "", "", result);
    Options preset;
    checker.read_presets(result, preset);
    for (const auto& [key, entry] : preset.entries())
        if (!result.has(key)) result.set(key, entry.value, entry.where);
    checker.add_defaults(result, table.where);
    checker.find_named_files(result);
    return result;
}

}  // namespace orbweaver
