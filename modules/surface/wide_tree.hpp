#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "large_pages.hpp"
#include "triangle_set.hpp"

namespace orbweaver::surface {

inline constexpr int kWide = 8;

/// Eight boxes side by side, in the tree's own coordinates (see WideTree). Baked as it stands.
struct alignas(64) WideNode {
    /// Lowest x, highest x, lowest y, ... of each child; rounded outwards. A child that is not there has a box
    /// that nothing meets.
    std::array<std::array<float, kWide>, 6> planes;
    std::array<std::uint32_t, kWide> children;  ///< a node's index, or leaf(first, count); or kNoChild
    std::array<std::uint32_t, kWide> reserved;  ///< 0
};
static_assert(sizeof(WideNode) == 256);

/// A triangle of a leaf: its vertices and its number.
struct WideTriangle {
    Corners corners;
    std::uint32_t face;
};
static_assert(sizeof(WideTriangle) == 16);

inline constexpr std::uint32_t kLeafBit = 0x80000000;
inline constexpr std::uint32_t kLeafFirstBits = 28;  ///< at most 2^28 triangles
inline constexpr std::uint32_t kLeafMost = 4;
inline constexpr int kWideStack = 560;  ///< enough for any tree that build_wide_tree makes

constexpr std::uint32_t leaf(std::uint32_t first, std::uint32_t count) noexcept {
    return kLeafBit | ((count - 1) << kLeafFirstBits) | first;
}
constexpr std::uint32_t leaf_first(std::uint32_t child) noexcept {
    return child & ((1U << kLeafFirstBits) - 1);
}
constexpr std::uint32_t leaf_count(std::uint32_t child) noexcept {
    return ((child & ~kLeafBit) >> kLeafFirstBits) + 1;
}

/// In place of a child that is not there: a leaf, for a ray whose numbers overflow may meet any box.
inline constexpr std::uint32_t kNoChild = leaf(0, 1);

constexpr bool is_leaf(std::uint32_t child) noexcept { return (child & kLeafBit) != 0; }
inline bool has_box(const WideNode& node, std::size_t i) noexcept {
    return node.planes[0][i] <= node.planes[1][i];
}

/// Corners of triangles (m), nine numbers each. Those of a leaf are rows, a number a triangle: x of corner 0,
/// of corner 1, of corner 2, then y, then z. One load so takes a coordinate of up to four, which a leaf has at
/// most; the last may reach three numbers beyond.
using LeafCorners = std::vector<double, LargePages<double>>;

/// The frame of the tree's coordinates: world = middle + size * tree, so that all boxes lie within [-1, 1].
struct WideFrame {
    Vec3 middle;      ///< m
    double size = 1;  ///< m, half the largest extent
};

/// Of the triangles' own bounds; size 1 when they have no extent.
WideFrame frame_of(const TriangleSet& set) noexcept;

/// A tree ready to be asked: spans of a baked file, or of WideTreeData. Node 0 is the root.
struct WideTree {
    WideFrame frame;
    std::span<const WideNode> nodes;
    std::span<const WideTriangle> triangles;  ///< in the order of the leaves
    std::span<const double> corners{};        ///< see corners_of_leaves(); a file has none
};

struct WideTreeData {
    WideFrame frame;
    std::vector<WideNode, LargePages<WideNode>> nodes;
    std::vector<WideTriangle, LargePages<WideTriangle>> triangles;
    LeafCorners corners;

    WideTree view() const noexcept { return {frame, nodes, triangles, corners}; }
    std::size_t memory_bytes() const noexcept {
        return nodes.capacity() * sizeof(WideNode) + triangles.capacity() * sizeof(WideTriangle) +
               corners.capacity() * sizeof(double);
    }
};

/// The corners of a tree's triangles where `set` has them: what rays want of it besides itself.
LeafCorners corners_of_leaves(const WideTree& tree, const TriangleSet& set);

/// Splits by the surface area heuristic over 16 bins (Wald 2007), seven splits to a node. Vertices are finite.
/// Throws Fault(limit) above 2^28 triangles.
WideTreeData build_wide_tree(const TriangleSet& set);

/// What is wrong with a tree that comes from a file, in words; empty when every index stays within it, no path
/// outgrows the stack of its traversal, and every face of `set` is in one leaf.
std::string fault_of(const WideTree& tree, const TriangleSet& set);

/// The nearest crossing: what FclTree finds, sooner. Boxes are met in single precision, widened by its
/// rounding; triangles in double.
SurfaceHit first_hit(const WideTree& tree, const TriangleSet& set, const SurfaceRay& ray) noexcept;

/// The point nearest to `point`, if within `reach` (m); of equally near ones the face of the lowest number.
SurfaceHit closest_point(const WideTree& tree, const TriangleSet& set, const Vec3& point,
                         double reach) noexcept;

}  // namespace orbweaver::surface
