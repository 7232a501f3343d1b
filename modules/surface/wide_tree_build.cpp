#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "orbweaver/fault.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

/// The next number from x towards `far`; never so small a one that it is denormal, over which processors take a
/// hundred times as long: a plane through the middle would be.
float beyond(float x, float far) noexcept {
    constexpr float kLeast = 1e-30F;
    const float next = std::nextafter(x, far);
    return std::abs(next) < kLeast ? std::copysign(kLeast, far) : next;
}

/// In the tree's coordinates, rounded outwards.
struct Box {
    std::array<float, 3> low{kFar, kFar, kFar};
    std::array<float, 3> high{-kFar, -kFar, -kFar};

    void include(const Box& o) noexcept {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], o.low[i]);
            high[i] = std::max(high[i], o.high[i]);
        }
    }
    /// Half its surface.
    float area() const noexcept {
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
    float center(std::size_t axis) const noexcept { return 0.5F * (low[axis] + high[axis]); }
};

struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    Box box;
    int depth = 0;
};

class Builder {
public:
    explicit Builder(const TriangleSet& set) : set_(set), order_(set.triangles.size()) {
        data_.frame = frame_of(set);
        std::iota(order_.begin(), order_.end(), 0U);
        boxes_.reserve(order_.size());
        for (const Corners& corners : set.triangles) boxes_.push_back(box_of(corners));
    }

    WideTreeData build() && {
        data_.nodes.reserve(order_.size() / 2 + 1);
        make_node(range_of(0, static_cast<std::uint32_t>(order_.size()), 0));
        data_.triangles.reserve(order_.size());
        for (const std::uint32_t face : order_) data_.triangles.push_back({set_.triangles[face], face});
        data_.corners = corners_of_leaves(data_.view(), set_);
        return std::move(data_);
    }

private:
    static constexpr std::uint32_t kSmallLeaf =
        3;  // at most so many triangles are not split for room in a node
    static constexpr std::size_t kBins = 16;
    static constexpr int kHeuristicDepth = 48;  // deeper, halves: no tree outgrows the stack of its traversal

    Box box_of(const Corners& corners) const {
        Box box;
        for (const std::uint32_t v : corners) {
            const Vec3 p = (set_.vertices[v] - data_.frame.middle) / data_.frame.size;
            const double at[3] = {p.x, p.y, p.z};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto rounded = static_cast<float>(at[i]);
                box.low[i] = std::min(box.low[i], beyond(rounded, -kFar));
                box.high[i] = std::max(box.high[i], beyond(rounded, kFar));
            }
        }
        return box;
    }

    Range range_of(std::uint32_t first, std::uint32_t count, int depth) const {
        Range range{first, count, {}, depth};
        for (std::uint32_t i = first; i < first + count; ++i) range.box.include(boxes_[order_[i]]);
        return range;
    }

    static std::vector<Range>::iterator largest_above(std::uint32_t count, std::vector<Range>& parts) {
        auto largest = parts.end();
        for (auto part = parts.begin(); part != parts.end(); ++part)
            if (part->count > count && (largest == parts.end() || part->box.area() > largest->box.area()))
                largest = part;
        return largest;
    }

    /// Splits the range of the largest surface until there are eight, or none is left to split.
    std::uint32_t make_node(const Range& whole) {
        std::vector<Range> parts{whole};
        while (parts.size() < kWide) {
            auto largest = largest_above(kLeafMost, parts);
            if (largest == parts.end()) largest = largest_above(kSmallLeaf, parts);
            if (largest == parts.end()) break;
            const std::uint32_t middle = split(*largest);
            const Range range = *largest;
            *largest = range_of(range.first, middle - range.first, range.depth + 1);
            parts.push_back(range_of(middle, range.first + range.count - middle, range.depth + 1));
        }
        const auto index = static_cast<std::uint32_t>(data_.nodes.size());
        data_.nodes.emplace_back();
        for (auto& plane : data_.nodes.back().planes) plane.fill(0);
        data_.nodes.back().children.fill(kNoChild);
        for (std::size_t i = 0; i < kWide; ++i) {
            const Box box = i < parts.size() ? parts[i].box : Box{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                data_.nodes[index].planes[2 * axis][i] = box.low[axis];
                data_.nodes[index].planes[2 * axis + 1][i] = box.high[axis];
            }
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const bool small = parts[i].count <= kLeafMost;
            const std::uint32_t child = small ? leaf(parts[i].first, parts[i].count) : make_node(parts[i]);
            data_.nodes[index].children[i] = child;
        }
        return index;
    }

    struct Cut {
        std::size_t axis = 0;
        std::size_t bin = 0;  // first of the upper part
        float low = 0, scale = 0;
        float cost = kFar;
    };

    std::size_t bin_of(const Cut& cut, std::uint32_t face) const noexcept {
        const float at = (boxes_[face].center(cut.axis) - cut.low) * cut.scale;
        return std::min(kBins - 1, static_cast<std::size_t>(std::max(0.0F, at)));
    }

    /// The cheapest cut across one axis: area times triangles, summed over both sides.
    Cut best_cut(const Range& range, std::size_t axis) const {
        float low = kFar, high = -kFar;
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const float center = boxes_[order_[i]].center(axis);
            low = std::min(low, center);
            high = std::max(high, center);
        }
        Cut cut{axis, 0, low, 0, kFar};
        if (!(high > low)) return cut;
        cut.scale = static_cast<float>(kBins) / (high - low);
        if (!std::isfinite(cut.scale)) return cut;
        std::array<Box, kBins> boxes;
        std::array<std::uint32_t, kBins> counts{};
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const std::size_t bin = bin_of(cut, order_[i]);
            boxes[bin].include(boxes_[order_[i]]);
            ++counts[bin];
        }
        std::array<float, kBins> upper{};
        Box box;
        std::uint32_t count = 0;
        for (std::size_t bin = kBins - 1; bin > 0; --bin) {
            box.include(boxes[bin]);
            count += counts[bin];
            upper[bin] = box.area() * static_cast<float>(count);
        }
        box = {};
        count = 0;
        for (std::size_t bin = 1; bin < kBins; ++bin) {
            box.include(boxes[bin - 1]);
            count += counts[bin - 1];
            const float cost = box.area() * static_cast<float>(count) + upper[bin];
            if (count > 0 && count < range.count && cost < cut.cost) {
                cut.cost = cost;
                cut.bin = bin;
            }
        }
        return cut;
    }

    /// Orders the range so that its two parts lie side by side; where the second begins.
    std::uint32_t split(const Range& range) {
        const auto begin = order_.begin() + range.first;
        const auto end = begin + range.count;
        Cut best;
        if (range.depth < kHeuristicDepth)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Cut cut = best_cut(range, axis);
                if (cut.cost < best.cost) best = cut;
            }
        if (std::isfinite(best.cost)) {
            const auto middle = std::stable_partition(
                begin, end, [&](std::uint32_t face) { return bin_of(best, face) < best.bin; });
            return range.first + static_cast<std::uint32_t>(middle - begin);
        }
        return range.first + range.count / 2;
    }

    TriangleSet set_;
    WideTreeData data_;
    std::vector<Box> boxes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

WideFrame frame_of(const TriangleSet& set) noexcept {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    Vec3 low{kInfinite, kInfinite, kInfinite}, high = -low;
    for (const Corners& corners : set.triangles)
        for (const std::uint32_t v : corners) {
            const Vec3& p = set.vertices[v];
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
    const Vec3 half = 0.5 * (high - low);
    const double size = std::max({half.x, half.y, half.z});
    return {low + half, size > 0 ? size : 1};
}

LeafCorners corners_of_leaves(const WideTree& tree, const TriangleSet& set) {
    LeafCorners corners(9 * tree.triangles.size() + 3);
    for (const WideNode& node : tree.nodes)
        for (std::size_t i = 0; i < kWide; ++i) {
            const std::uint32_t child = node.children[i];
            if (!is_leaf(child) || !has_box(node, i)) continue;
            const auto triangles = tree.triangles.subspan(leaf_first(child), leaf_count(child));
            double* at = &corners[9 * std::size_t{leaf_first(child)}];
            for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z})
                for (std::size_t corner = 0; corner < 3; ++corner)
                    for (const WideTriangle& each : triangles) *at++ = set.vertices[each.corners[corner]].*axis;
        }
    return corners;
}

WideTreeData build_wide_tree(const TriangleSet& set) {
    if (set.triangles.size() >= (1U << kLeafFirstBits))
        throw Fault(FaultKind::limit, "a tree over " + std::to_string(set.triangles.size()) +
                                          " triangles is not possible; expected fewer than " +
                                          std::to_string(1U << kLeafFirstBits) + "; divide the mesh");
    return set.triangles.empty() ? WideTreeData{} : Builder(set).build();
}

}  // namespace orbweaver::surface
