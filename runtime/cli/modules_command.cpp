#include "cli/modules_command.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "orbweaver/fault.hpp"
#include "plan/scene_table.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver {

namespace {

void print_option(const OptionSpec& spec) {
    std::string kind(to_string(spec.type));
    if (spec.unit != "1") kind += fmt::format(" of {}", spec.unit);
    if (!spec.choices.empty()) kind += ": " + join_names(spec.choices);
    if (const std::string range = range_text(spec); !range.empty()) kind += ", " + range;
    std::string standard = spec.required ? "required" : "no default";
    if (spec.default_value) {
        const Array* array = spec.default_value->array();
        if (array != nullptr) {
            std::vector<std::string> parts;
            for (const Node& element : *array) parts.push_back(show(element));
            standard = fmt::format("default [{}]", fmt::join(parts, ", "));
        } else {
            standard = "default " + show(*spec.default_value);
        }
    }
    fmt::print("  {:<28} {} ({}; {})\n", spec.key, spec.meaning, kind, standard);
}

void print_names(const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) fmt::print("  {:<9}{}\n", what, fmt::join(names, ", "));
}

void print_module(const Manifest& manifest) {
    fmt::print("{} {}: {}\n  at       {}\n", manifest.id, manifest.version, manifest.summary, manifest.library);
    if (!manifest.table.empty())
        fmt::print("  table    [{}]{}\n", manifest.table,
                   manifest.several ? ", or several [[" + manifest.table + "]]" : "");
    print_names("provides", manifest.provides);
    print_names("needs", manifest.needs);
    print_names("uses", manifest.uses);
    print_names("collects", manifest.collects);
    print_names("meets", manifest.meets);
    print_names("brings", manifest.libraries);
    std::vector<std::string> phases;
    for (const Phase phase : manifest.phases) phases.emplace_back(to_string(phase));
    print_names("phases", phases);
    if (!manifest.options.empty()) fmt::print("options:\n");
    for (const OptionSpec& spec : manifest.options) print_option(spec);
}

}  // namespace

int print_modules(const Catalog& catalog, const std::string& name) {
    for (const Diagnostic& fault : catalog.faults) fmt::print(stderr, "{}\n", to_string(fault));
    if (name == "scene") {
        fmt::print("scene: what holds for the whole scene, the table [scene]\noptions:\n");
        for (const OptionSpec& spec : scene_options()) print_option(spec);
        return 0;
    }
    if (!name.empty()) {
        const Manifest* manifest = find(catalog, name);
        if (manifest == nullptr) {
            std::vector<std::string> names;
            for (const Manifest& each : catalog.manifests) names.push_back(each.id);
            fmt::print(stderr, "there is no module '{}'; expected one of {}; searched {}\n", name,
                       join_names(names), join_names(catalog.directories, ", "));
            return static_cast<int>(FaultKind::invalid);
        }
        print_module(*manifest);
        return 0;
    }
    for (const Manifest& manifest : catalog.manifests)
        fmt::print("{:<16} {:<8} {}\n{:<26}{}\n", manifest.id, manifest.version, manifest.summary, "",
                   manifest.library);
    fmt::print("\nsearched: {}\n", join_names(catalog.directories, ", "));
    return catalog.faults.empty() ? 0 : static_cast<int>(FaultKind::invalid);
}

}  // namespace orbweaver
