#include <algorithm>
#include <cmath>

#include "wide_tree.hpp"

namespace orbweaver::surface {

namespace {

/// Leaves of the tree mark their triangles.
std::string mark_leaf(std::uint32_t child, std::vector<std::uint8_t>& marks) {
    const std::size_t first = leaf_first(child);
    const std::size_t end = first + leaf_count(child);
    if (leaf_count(child) > kLeafMost)
        return "a leaf of the tree has " + std::to_string(leaf_count(child)) + " triangles; expected at most " +
               std::to_string(kLeafMost);
    if (end > marks.size())
        return "a leaf of the tree ends at triangle " + std::to_string(end) + " of " +
               std::to_string(marks.size());
    for (std::size_t i = first; i < end; ++i)
        if (marks[i]++ != 0) return "triangle " + std::to_string(i) + " of the tree is in two leaves";
    return {};
}

std::string nodes_fault(const WideTree& tree) {
    std::vector<std::uint8_t> depth(tree.nodes.size(), 0);
    std::vector<std::uint8_t> marks(tree.triangles.size(), 0);
    constexpr int kDeepest = (kWideStack - kWide) / (kWide - 1);
    for (std::size_t n = 0; n < tree.nodes.size(); ++n)
        for (std::size_t i = 0; i < kWide; ++i) {
            const std::uint32_t child = tree.nodes[n].children[i];
            if (!has_box(tree.nodes[n], i)) {
                if (child != kNoChild)
                    return "node " + std::to_string(n) + " of the tree has a child without a box";
                continue;
            }
            if (is_leaf(child)) {
                if (std::string fault = mark_leaf(child, marks); !fault.empty()) return fault;
            } else if (child <= n || child >= tree.nodes.size()) {
                return "node " + std::to_string(n) + " of the tree has node " + std::to_string(child) +
                       " below it, of " + std::to_string(tree.nodes.size());
            } else if (depth[n] >= kDeepest) {
                return "the tree is deeper than " + std::to_string(kDeepest);
            } else {
                depth[child] = static_cast<std::uint8_t>(std::max<int>(depth[child], depth[n] + 1));
            }
        }
    const auto lost = std::find(marks.begin(), marks.end(), 0);
    if (lost == marks.end()) return {};
    return "triangle " + std::to_string(lost - marks.begin()) + " of the tree is in no leaf";
}

std::string triangles_fault(const WideTree& tree, const TriangleSet& set) {
    std::vector<bool> seen(set.triangles.size(), false);
    for (const WideTriangle& each : tree.triangles) {
        if (each.face >= seen.size() || seen[each.face] || each.corners != set.triangles[each.face])
            return "face " + std::to_string(each.face) + " in the tree is not the mesh's, or is there twice";
        seen[each.face] = true;
    }
    return {};
}

}  // namespace

std::string fault_of(const WideTree& tree, const TriangleSet& set) {
    if (tree.triangles.size() != set.triangles.size() || (tree.nodes.empty() && !set.triangles.empty()))
        return "the tree holds " + std::to_string(tree.triangles.size()) + " triangles of " +
               std::to_string(set.triangles.size());
    if (!is_finite(tree.frame.middle) || !(tree.frame.size > 0) || !std::isfinite(tree.frame.size))
        return "the tree's frame is not finite";
    const std::string fault = nodes_fault(tree);
    return fault.empty() ? triangles_fault(tree, set) : fault;
}

}  // namespace orbweaver::surface
