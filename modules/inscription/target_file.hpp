#pragma once

#include <string>
#include <string_view>

#include "orbweaver/baked_file.hpp"
#include "raster.hpp"
#include "target.hpp"

namespace orbweaver::inscription {

inline constexpr std::string_view kTargetType = "target";
/// Of the sections of a target's file; others are refused.
inline constexpr std::uint32_t kTargetVersion = 1;
/// Of what makes a target from its source; another one bakes it again.
inline constexpr std::uint32_t kTargetBuilder = 1;
inline constexpr std::uint32_t kSmallestSide = 16;   ///< of a target, pixels
inline constexpr std::uint32_t kLargestSide = 4096;  ///< of a target, pixels

/// Writes a target, its dilation included, as a baked file; the same arguments give the same bytes. `recipe` is
/// lines of "key: value". Throws Fault as AtomicFile does, and Fault(invalid) for coverage without anything
/// dark.
void write_target(const std::string& path, const Bitmap& coverage, const ContentHash& source,
                  const std::string& recipe);

/// The target in a file of kTargetType and kTargetVersion, where it lies: valid while the file lives. Throws
/// Fault(invalid) for sides that are out of range or disagree with the sections, and for values that are
/// neither 0 nor 1.
Target target_in(const BakedFile& file);

/// Lines of "key: value": how it was made.
std::string_view recipe_in(const BakedFile& file);
/// The kTargetBuilder that made it.
std::uint32_t builder_in(const BakedFile& file);

/// Proves a target sound: dilates its coverage anew and compares. Throws Fault(invalid) for the first
/// difference, and for coverage in which nothing is dark.
void verify_target(const BakedFile& file);

}  // namespace orbweaver::inscription
