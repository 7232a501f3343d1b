#pragma once

#include <span>
#include <string>
#include <string_view>

namespace orbweaver {

/// The name closest to `wrong` by edit distance, or "" when none is near enough to be meant.
std::string nearest_name(std::string_view wrong, std::span<const std::string> names);

/// "a, b or c"
std::string join_names(std::span<const std::string> names, std::string_view last = " or ");

}  // namespace orbweaver
