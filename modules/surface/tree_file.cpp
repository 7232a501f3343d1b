#include "tree_file.hpp"

#include "orbweaver/fault.hpp"

namespace orbweaver::surface {

void add_tree(BakedWriter& writer, const WideTreeData& tree) {
    writer.add("tree_frame", std::span(&tree.frame, 1));
    writer.add("tree_nodes", std::span(tree.nodes));
    writer.add("tree_triangles", std::span(tree.triangles));
}

std::optional<WideTree> tree_in(const BakedFile& file, const TriangleSet& set) {
    if (!file.has("tree_nodes")) return std::nullopt;
    const auto frame = file.section<WideFrame>("tree_frame");
    const WideTree tree{frame.empty() ? WideFrame{} : frame[0], file.section<WideNode>("tree_nodes"),
                        file.section<WideTriangle>("tree_triangles")};
    const std::string fault = fault_of(tree, set);
    if (!fault.empty())
        throw Fault(FaultKind::invalid,
                    file.path() + ": is unsound: " + fault + "; bake it again with orbweaver-assets");
    return tree;
}

}  // namespace orbweaver::surface
