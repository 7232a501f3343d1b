#pragma once

#include <optional>
#include <string>

#include "web.hpp"

namespace orbweaver::web {

inline constexpr std::size_t kLargestNetworkFile = 64u << 20;  ///< bytes

/// Reads a network of the user's own, SI units:
///   {"particles": [[x, y, z], ...], "masses": [m, ...] or m, "fixed": [i, ...],
///    "springs": [[i, j, rest_length, stiffness, damping], ...]}
/// Every fault is a sentence that names the file and the element, as in "springs[3]"; at most ten are
/// reported. Throws Fault(limit) for a file or a network beyond the limits.
std::optional<Web> read_network(const std::string& path, Diagnostics& faults);

/// The same from text; `name` stands for the file in sentences.
std::optional<Web> parse_network(const std::string& text, const std::string& name, Diagnostics& faults);

}  // namespace orbweaver::web
