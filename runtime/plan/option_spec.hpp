#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
    preset,  ///< a TOML file by name, whose keys are the module's options
    named,   ///< the same with keys of its own: the module is given its path
};

/// One option of a module, as its manifest declares it.
struct OptionSpec {
    std::string key;  ///< dotted when it lies in a nested table; a part * stands for names of the scene's own
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
    std::string folder;  ///< of a preset or a named file, below assets/
    std::string asset;   ///< what is baked from it: "mesh" from a file, "target" from all such options
                         ///< of a module together; empty: it is used as it is
    std::string meaning;
    std::string plan;  ///< what a plan adds to its module where the scene gives this option; empty: nothing
};

std::string_view to_string(OptionType type) noexcept;
/// "in [0, 1]", "above 0": the range in words; empty when there is none.
std::string range_text(const OptionSpec& spec);

}  // namespace orbweaver
