#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "orbweaver/baked_file.hpp"

namespace orbweaver {

/// What a baked target holds and how it was made, for a person.
std::string target_text(const BakedFile& file);

/// The same for a program: an object with kind, version, builder, source_hash, bytes, width, height, dilation,
/// dark_share, dilated_share and recipe.
std::string target_json(const BakedFile& file);

/// The same as a picture, a PNG file in memory: coverage black, what dilation adds to it gray, the rest white.
std::vector<std::uint8_t> target_png(const BakedFile& file);

}  // namespace orbweaver
