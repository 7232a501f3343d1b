#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/module.hpp"
#include "scene/node.hpp"

namespace orbweaver {

enum class OptionType : std::uint8_t {
    boolean,
    integer,
    number,
    text,
    choice,
    vector,
    vectors,
    numbers,
    file,
    preset
};

/// One option of a module, as its manifest declares it.
struct OptionSpec {
    std::string key;  ///< dotted when it lies in a nested table
    OptionType type = OptionType::text;
    std::string unit = "1";
    std::optional<Node> default_value;
    bool required = false;
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool above_min = false;  ///< min itself is out of range
    bool below_max = false;  ///< max itself is out of range
    std::size_t length = 0;  ///< of numbers; 0: any
    std::vector<std::string> choices;
    std::string folder;  ///< of a preset, below assets/
    std::string meaning;
};

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
    std::vector<Phase> phases;
    std::vector<std::string> libraries;
    std::vector<OptionSpec> options;
};

/// Reads a manifest; appends every fault to `faults` and returns nothing if there was one.
std::optional<Manifest> read_manifest(const std::string& path, Diagnostics& faults);
std::optional<Manifest> parse_manifest(const std::string& text, const std::string& name, Diagnostics& faults);

std::string_view to_string(Phase phase) noexcept;
std::string_view to_string(OptionType type) noexcept;
/// "in [0, 1]", "above 0": the range in words; empty when there is none.
std::string range_text(const OptionSpec& spec);

}  // namespace orbweaver
