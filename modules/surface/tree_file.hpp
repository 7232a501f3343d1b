#pragma once

#include <optional>

#include "baked/baked_writer.hpp"
#include "orbweaver/baked_file.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// Adds a tree's sections to a mesh's file. The tree outlives the writer.
void add_tree(BakedWriter& writer, const WideTreeData& tree);

/// The tree in a mesh's file, where it lies: valid while the file lives; none when it was baked without. Throws
/// Fault(invalid) for one that does not fit the mesh.
std::optional<WideTree> tree_in(const BakedFile& file, const TriangleSet& set);

}  // namespace orbweaver::surface
