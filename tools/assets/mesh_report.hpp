#pragma once

#include <string>

#include "orbweaver/baked_file.hpp"

namespace orbweaver {

/// What a baked mesh holds and what validation found in its source, for a person.
std::string mesh_text(const BakedFile& file);

/// The same for a program: an object with at least kind, version, source_hash, triangles, vertices, edges,
/// border_edges, nonmanifold_edges, shells, dropped_degenerate, dropped_duplicate and flipped.
std::string mesh_json(const BakedFile& file);

}  // namespace orbweaver
