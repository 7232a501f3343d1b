#include "plan/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "orbweaver/fault.hpp"
#include "plan/table_reader.hpp"
#include "scene/toml_reader.hpp"
#include "scene/units.hpp"

namespace orbweaver {

namespace {

constexpr std::array<std::string_view, 6> kPhaseNames = {"sense",     "act",    "integrate",
                                                         "constrain", "derive", "present"};
constexpr std::array<std::string_view, 11> kTypeNames = {"boolean", "integer", "number",  "text",
                                                         "choice",  "vector",  "vectors", "numbers",
                                                         "file",    "preset",  "named"};
constexpr std::array<std::string_view, 6> kWhenNames = {"",       "pictures",  "offscreen",
                                                        "window", "recording", "threads"};

template <std::size_t N>
std::optional<std::size_t> index_of(const std::array<std::string_view, N>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

OptionSpec read_option(const std::string& key, const Node& node, Diagnostics& faults) {
    OptionSpec spec;
    spec.key = key;
    if (node.table() == nullptr) {
        faults.push_back({node.where, fmt::format("option '{}' is {}", key, show(node)), "a table", ""});
        return spec;
    }
    TableReader reader(node, faults);
    std::string type;
    reader.take("type", type);
    if (const auto index = index_of(kTypeNames, type))
        spec.type = static_cast<OptionType>(*index);
    else
        faults.push_back({node.where, fmt::format("option '{}' has no type '{}'", key, type),
                          fmt::format("one of {}", fmt::join(kTypeNames, ", ")), ""});
    reader.take("unit", spec.unit);
    if (!parse_unit(spec.unit))
        faults.push_back(
            {node.where, fmt::format("option '{}' has the unknown unit '{}'", key, spec.unit), "", ""});
    if (const Node* value = reader.take("default")) spec.default_value = *value;
    reader.take("required", spec.required);
    if (key.find('*') != std::string::npos && (spec.default_value || spec.required))
        faults.push_back({node.where, fmt::format("option '{}' has a default or is required", key),
                          "neither, of an option whose name the scene gives", ""});
    reader.take_number("min", spec.min);
    reader.take_number("max", spec.max);
    spec.above_min = reader.take_number("above", spec.min);
    spec.below_max = reader.take_number("below", spec.max);
    std::int64_t length = 0;
    reader.take("length", length);
    if (length < 0)
        faults.push_back(
            {node.where, fmt::format("option '{}' has a length of {}", key, length), "a count", ""});
    spec.length = static_cast<std::size_t>(length);
    reader.take("choices", spec.choices);
    reader.take("folder", spec.folder);
    reader.take("asset", spec.asset);
    if (!spec.asset.empty() && spec.asset != "target" &&
        (spec.asset != "mesh" || spec.type != OptionType::file))
        faults.push_back({node.where, fmt::format("option '{}' has the asset '{}'", key, spec.asset),
                          "\"mesh\", of an option of type file, or \"target\"", ""});
    reader.take("meaning", spec.meaning);
    reader.take("plan", spec.plan);
    if (spec.meaning.empty()) reader.missing("meaning");
    reader.finish();
    return spec;
}

void read_phases(TableReader& reader, const Node& root, Manifest& manifest, Diagnostics& faults) {
    std::vector<std::string> names;
    reader.take("phases", names);
    for (const std::string& name : names) {
        if (const auto index = index_of(kPhaseNames, name))
            manifest.phases.push_back(static_cast<Phase>(*index));
        else
            faults.push_back({root.where, fmt::format("there is no phase '{}'", name),
                              fmt::format("{}", fmt::join(kPhaseNames, ", ")), ""});
    }
}

void read_options(TableReader& reader, Manifest& manifest, Diagnostics& faults) {
    const Node* options = reader.take("options");
    if (options == nullptr) return;
    if (options->table() == nullptr) return reader.wrong(*options, "options", "a table");
    for (const Member& member : *options->table())
        manifest.options.push_back(read_option(member.key, member.node, faults));
}

}  // namespace

std::string_view to_string(Phase phase) noexcept { return kPhaseNames[static_cast<std::size_t>(phase)]; }
std::string_view to_string(OptionType type) noexcept { return kTypeNames[static_cast<std::size_t>(type)]; }

std::string range_text(const OptionSpec& spec) {
    const bool low = std::isfinite(spec.min);
    const bool high = std::isfinite(spec.max);
    std::string text;
    if (low) text += fmt::format("{} {}", spec.above_min ? "above" : "at least", spec.min);
    if (low && high) text += " and ";
    if (high) text += fmt::format("{} {}", spec.below_max ? "below" : "at most", spec.max);
    return text;
}

std::optional<Manifest> parse_manifest(const std::string& text, const std::string& name, Diagnostics& faults) {
    const std::size_t before = faults.size();
    Manifest manifest;
    manifest.path = name;
    manifest.text = text;
    Node root;
    try {
        root = read_toml_text(text, name);
    } catch (const Fault& fault) {
        faults.push_back({{}, fault.what(), "", ""});
        return std::nullopt;
    }
    TableReader reader(root, faults);
    reader.take("id", manifest.id);
    reader.take("version", manifest.version);
    reader.take("summary", manifest.summary);
    reader.take("table", manifest.table);
    reader.take("several", manifest.several);
    reader.take("when", manifest.when);
    reader.take("provides", manifest.provides);
    reader.take("needs", manifest.needs);
    reader.take("uses", manifest.uses);
    reader.take("collects", manifest.collects);
    reader.take("meets", manifest.meets);
    reader.take("libraries", manifest.libraries);
    read_phases(reader, root, manifest, faults);
    if (manifest.id.empty()) reader.missing("id");
    if (manifest.version.empty()) reader.missing("version");
    if (!index_of(kWhenNames, manifest.when))
        faults.push_back({root.where, fmt::format("'when' is \"{}\"", manifest.when),
                          fmt::format("one of {}", fmt::join(kWhenNames.begin() + 1, kWhenNames.end(), ", ")),
                          ""});
    read_options(reader, manifest, faults);
    if (const Node* study = reader.take("study")) manifest.study = read_study(*study, manifest.options, faults);
    reader.finish();
    if (faults.size() > before) return std::nullopt;
    return manifest;
}

std::optional<Manifest> read_manifest(const std::string& path, Diagnostics& faults) {
    std::error_code error;
    const bool regular = std::filesystem::is_regular_file(path, error);
    std::ifstream file;
    std::stringstream text;
    if (regular) file.open(path, std::ios::binary);
    if (regular) text << file.rdbuf();
    if (!regular || !file) {
        faults.push_back({{path, 0, 0}, "this manifest cannot be read", "a TOML file", ""});
        return std::nullopt;
    }
    auto manifest = parse_manifest(text.str(), path, faults);
    if (manifest) manifest->library = std::filesystem::path(path).replace_extension(".so").string();
    return manifest;
}

}  // namespace orbweaver
