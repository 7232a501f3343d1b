#pragma once

#include <string>

namespace orbweaver {

/// The type that a baked file's header names, unchecked: for who reads files of several types. Empty for a file
/// that is not baked or cannot be read.
std::string baked_type(const std::string& path);

}  // namespace orbweaver
