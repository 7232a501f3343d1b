#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "build.hpp"
#include "orbweaver/baked_file.hpp"

namespace orbweaver::mesh {

/// A file that an importer read beside its source, such as the .bin of a .gltf.
struct Companion {
    std::string path;  ///< relative to the source's folder
    ContentHash hash;
};

/// As the section "companions" of a baked file keeps them: path and hash, each ended by a zero.
std::vector<char> to_section(std::span<const Companion> companions);

/// Where the mesh baked from this source belongs in cache_folder(): named after the source's bytes, the recipe
/// and the builder's versions. Throws Fault(invalid) for a source that cannot be read.
std::string cached_path(const std::string& source, const Recipe& recipe);

/// What was baked from this source, if it is there, sound, and made from the companions that lie beside the
/// source now.
std::optional<BakedFile> find_cached(const std::string& source, const Recipe& recipe);

/// A mesh to be walked on: a baked file itself, or what `orbweaver-assets bake SCENE` made from a source.
/// Throws Fault(invalid) for one that is not baked yet, or of which the cache holds something damaged or
/// outdated, and says how it is made.
BakedFile open_mesh(const std::string& path);

}  // namespace orbweaver::mesh
