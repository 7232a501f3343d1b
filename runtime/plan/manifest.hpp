#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/module.hpp"
#include "plan/option_spec.hpp"
#include "plan/study_spec.hpp"

namespace orbweaver {

/// What a module says of itself without any of its code having run.
struct Manifest {
    std::string path;     ///< of the manifest
    std::string library;  ///< of the shared object beside it
    std::string text;     ///< the manifest, letter by letter
    std::string id;
    std::string version;
    std::string summary;
    std::string table;  ///< of the scene that asks for it; empty: none does
    bool several = false;
    std::string when;  ///< the request it waits for: "pictures", "offscreen", "window", "recording", "threads"
    std::vector<std::string> provides;
    std::vector<std::string> needs;
    std::vector<std::string> uses;
    std::vector<std::string> collects;
    std::vector<std::string> meets;  ///< contracts that it finds once all are attached, in whatever order
    std::vector<Phase> phases;
    std::vector<std::string> libraries;
    std::vector<OptionSpec> options;
    std::optional<StudySpec> study;  ///< how its error and stability can be studied
};

/// Reads a manifest; appends every fault to `faults` and returns nothing if there was one.
std::optional<Manifest> read_manifest(const std::string& path, Diagnostics& faults);
std::optional<Manifest> parse_manifest(const std::string& text, const std::string& name, Diagnostics& faults);

std::string_view to_string(Phase phase) noexcept;

}  // namespace orbweaver
