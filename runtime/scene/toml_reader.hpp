#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "scene/node.hpp"

namespace orbweaver {

inline constexpr std::size_t kMaxSceneBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMaxKeyDepth = 64;

/// Reads a TOML file into a tree whose values know their place. `name` is what diagnostics call the file.
/// Throws Fault: invalid when it cannot be read or is not TOML, limit when it is larger than
/// kMaxSceneBytes or nests keys deeper than kMaxKeyDepth.
Node read_toml_file(const std::string& path);
Node read_toml_text(std::string_view text, const std::string& name);

}  // namespace orbweaver
