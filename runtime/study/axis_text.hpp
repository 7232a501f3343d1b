#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/units.hpp"

namespace orbweaver::study {

/// "10 us..20 ms:16", with ":lin" or ":log" behind it or not.
struct AxisRange {
    Quantity low;
    Quantity high;
    int count = 0;
    std::optional<bool> log;
};

/// "rk4,verlet": values as an override writes them.
using AxisList = std::vector<std::string>;

/// An axis as typed.
struct AxisText {
    std::string path;  ///< "web.step"
    std::variant<AxisRange, AxisList> values;
};

/// Nothing when it is neither PATH=LOW..HIGH:COUNT[:lin|:log], with numbers that rise and a COUNT of 2 to 200,
/// nor PATH=A,B,... with 2 to 200 values. Commas within brackets, braces or quotes belong to a value.
std::optional<AxisText> parse_axis(const std::string& text);

/// The part of `text` before `mark`, which is cut off with it; nothing when there is no mark.
std::optional<std::string> cut(std::string& text, std::string_view mark);
bool is_digits(const std::string& text);

}  // namespace orbweaver::study
