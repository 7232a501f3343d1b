#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::film {

/// A failed call of the system in words. Full disk, quota and file size limit are FaultKind::limit, all
/// else is internal. `error` is an errno.
Fault io_fault(const std::string& action, const std::filesystem::path& path, int error);

/// The name under which `path` grows, beside it: ".NAME.part.EXT". It keeps the extension, by which
/// encoders tell the format.
std::filesystem::path part_path(const std::filesystem::path& path);

/// Gives a finished part its final name. Throws Fault; the part stays.
void rename_part(const std::filesystem::path& path);

/// Writes `bytes` to `path` under its part name, then renames it: under its final name a file is whole or
/// not there. Throws Fault, and leaves no part behind.
void write_whole(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Makes a directory and those above it, and tries it by writing a file. Throws Fault.
void make_writable_directory(const std::filesystem::path& directory);

}  // namespace orbweaver::film
