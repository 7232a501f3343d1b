#include "placing.hpp"

#include <algorithm>
#include <cmath>

namespace orbweaver::inscription {

namespace {

constexpr double kBeside = 0.005;  ///< share of what is dark that may lie on ground that is not writable
constexpr int kHalvings = 12;      ///< of the range of scales

/// A run of rows that are dark somewhere.
struct Band {
    std::uint32_t top, bottom;
};

std::vector<Band> dark_bands(const Target& target) {
    std::vector<Band> bands;
    for (std::uint32_t y = 0; y < target.height; ++y) {
        const auto row = target.coverage.subspan(target.index(0, y), target.width);
        if (std::find(row.begin(), row.end(), 1) == row.end()) continue;
        if (!bands.empty() && bands.back().bottom == y)
            ++bands.back().bottom;
        else
            bands.push_back({y, y + 1});
    }
    return bands;
}

Box close_block(const Target& target, const Band& band) {
    return dark_box(target.coverage, target.width, {0, band.top, target.width, band.bottom});
}

/// How many pixels each one is from ground that is not writable, or from the edge, in steps to the four sides.
std::vector<std::uint32_t> depths(const Bitmap& writable) {
    const std::uint32_t width = writable.width, height = writable.height;
    std::vector<std::uint32_t> depth(writable.values.size());
    const auto at = [&](std::uint32_t x, std::uint32_t y) -> std::uint32_t& {
        return depth[static_cast<std::size_t>(y) * width + x];
    };
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x)
            if (writable.row(y)[x] != 0)
                at(x, y) = 1 + (x > 0 && y > 0 ? std::min(at(x - 1, y), at(x, y - 1)) : 0);
    for (std::uint32_t y = height; y-- > 0;)
        for (std::uint32_t x = width; x-- > 0;)
            if (writable.row(y)[x] != 0)
                at(x, y) = std::min(
                    at(x, y), 1 + (x + 1 < width && y + 1 < height ? std::min(at(x + 1, y), at(x, y + 1)) : 0));
    return depth;
}

struct Offset {
    std::int32_t x, y;
};

/// What is dark in a block at some scale, pixels of the page from its middle.
std::vector<Offset> dark_offsets(const Target& target, const Box& block, double scale) {
    std::vector<Offset> dark;
    const auto reach_x = static_cast<std::int32_t>(std::ceil(0.5 * block.width() * scale));
    const auto reach_y = static_cast<std::int32_t>(std::ceil(0.5 * block.height() * scale));
    for (std::int32_t y = -reach_y; y <= reach_y; ++y)
        for (std::int32_t x = -reach_x; x <= reach_x; ++x) {
            const double tx = std::floor(x / scale + 0.5 * block.width()) + block.left;
            const double ty = std::floor(y / scale + 0.5 * block.height()) + block.top;
            if (tx < block.left || ty < block.top || tx >= block.right || ty >= block.bottom) continue;
            if (target.coverage[target.index(static_cast<std::uint32_t>(tx), static_cast<std::uint32_t>(ty))] !=
                0)
                dark.push_back({x, y});
        }
    return dark;
}

/// Looks for places on ground of which it knows how deep it is.
class Ground {
public:
    explicit Ground(const Bitmap& writable)
        : width_(writable.width), height_(writable.height), depth_(depths(writable)) {}

    /// A place for a block whose middle lies in rows from `top` to before `bottom`: the nearest to a column,
    /// and of those there the deepest.
    std::optional<Spot> best_place(const std::vector<Offset>& dark, std::uint32_t top, std::uint32_t bottom,
                                   std::uint32_t column) const {
        for (std::uint32_t aside = 0; aside < width_; ++aside)
            for (const std::int64_t x : {std::int64_t{column} - aside, std::int64_t{column} + aside}) {
                std::optional<Spot> best;
                std::uint64_t deepest = 0;
                for (std::uint32_t y = top; y < bottom; ++y)
                    if (const std::uint64_t depth = depth_at(dark, x, y); depth > deepest) {
                        deepest = depth;
                        best = {static_cast<double>(x) + 0.5, y + 0.5};
                    }
                if (best) return best;
            }
        return std::nullopt;
    }

private:
    /// Of all that is dark together; 0 where it does not fit.
    std::uint64_t depth_at(const std::vector<Offset>& dark, std::int64_t x, std::uint32_t y) const {
        const auto most = static_cast<std::size_t>(kBeside * static_cast<double>(dark.size()));
        std::size_t beside = 0;
        std::uint64_t sum = 0;
        for (const Offset& each : dark) {
            const std::int64_t px = x + each.x, py = std::int64_t{y} + each.y;
            const bool seen = px >= 0 && py >= 0 && px < width_ && py < height_;
            const std::uint32_t depth =
                seen ? depth_[static_cast<std::size_t>(py) * width_ + static_cast<std::size_t>(px)] : 0;
            if (depth == 0 && ++beside > most) return 0;
            sum += depth;
        }
        return sum;
    }

    std::uint32_t width_, height_;
    std::vector<std::uint32_t> depth_;
};

}  // namespace

Placement whole(const Target& target, const Spot& middle, double width) {
    return {{0, 0, target.width, target.height}, middle, width / target.width};
}

Box box_of(const Placement& placed, std::uint32_t side) {
    const double width = placed.block.width() * placed.scale, height = placed.block.height() * placed.scale;
    const auto pixel = [&](double at) {
        return static_cast<std::uint32_t>(std::clamp(at, 0.0, static_cast<double>(side)));
    };
    return {pixel(std::floor(placed.middle.x - 0.5 * width)), pixel(std::floor(placed.middle.y - 0.5 * height)),
            pixel(std::ceil(placed.middle.x + 0.5 * width)), pixel(std::ceil(placed.middle.y + 0.5 * height))};
}

Bitmap place(const Target& target, const std::vector<Placement>& placements, std::uint32_t side) {
    Bitmap page(side, side);
    for (const Placement& placed : placements) {
        const Box& block = placed.block;
        const Box onto = box_of(placed, side);
        const double left = placed.middle.x - 0.5 * block.width() * placed.scale;
        const double top = placed.middle.y - 0.5 * block.height() * placed.scale;
        for (std::uint32_t y = onto.top; y < onto.bottom; ++y) {
            const double row = std::floor((y + 0.5 - top) / placed.scale);
            if (row < 0 || row >= block.height()) continue;
            for (std::uint32_t x = onto.left; x < onto.right; ++x) {
                const double column = std::floor((x + 0.5 - left) / placed.scale);
                if (column < 0 || column >= block.width()) continue;
                page.row(y)[x] |= target.coverage[target.index(block.left + static_cast<std::uint32_t>(column),
                                                               block.top + static_cast<std::uint32_t>(row))];
            }
        }
    }
    return page;
}

double dark_beside(const Target& target, const Placement& placed, std::uint32_t side) {
    const Box& block = placed.block;
    const auto is_beside = [&](double from_middle, double middle) {
        const double at = middle + placed.scale * from_middle;
        return at < 0 || at >= side;
    };
    double beside = 0;
    for (std::uint32_t y = block.top; y < block.bottom; ++y)
        for (std::uint32_t x = block.left; x < block.right; ++x)
            if (target.coverage[target.index(x, y)] != 0 &&
                (is_beside(x + 0.5 - 0.5 * (block.left + block.right), placed.middle.x) ||
                 is_beside(y + 0.5 - 0.5 * (block.top + block.bottom), placed.middle.y)))
                beside += placed.scale * placed.scale;
    return beside;
}

std::vector<Box> blocks_of(const Target& target, std::size_t lines) {
    const std::vector<Band> bands = dark_bands(target);
    if (bands.empty()) return {};
    const Band all{bands.front().top, bands.back().bottom};
    if (lines < 2 || bands.size() < lines) return {close_block(target, all)};
    // Rows between lines are wider than those between a letter and its dot.
    std::vector<std::size_t> gaps;  // each by the band above it
    for (std::size_t i = 0; i + 1 < bands.size(); ++i) gaps.push_back(i);
    const auto width = [&](std::size_t gap) { return bands[gap + 1].top - bands[gap].bottom; };
    std::stable_sort(gaps.begin(), gaps.end(),
                     [&](std::size_t a, std::size_t b) { return width(a) > width(b); });
    gaps.resize(lines - 1);
    std::sort(gaps.begin(), gaps.end());
    const std::size_t middle = gaps[(lines + 1) / 2 - 1];
    return {close_block(target, {all.top, bands[middle].bottom}),
            close_block(target, {bands[middle + 1].top, all.bottom})};
}

std::optional<std::vector<Placement>> best_placements(const Target& target, const std::vector<Box>& blocks,
                                                      const Bitmap& writable, const Spot& hub, double least,
                                                      double most) {
    const Ground ground(writable);
    const auto row = static_cast<std::uint32_t>(std::clamp(hub.y, 0.0, static_cast<double>(writable.height)));
    const auto column = static_cast<std::uint32_t>(std::clamp(hub.x, 0.0, static_cast<double>(writable.width)));
    const auto at_scale = [&](double scale) -> std::optional<std::vector<Placement>> {
        std::vector<Placement> placed;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            const auto half = static_cast<std::uint32_t>(std::ceil(0.5 * blocks[i].height() * scale));
            const bool above = i == 0 && blocks.size() > 1, below = i > 0;
            const std::uint32_t top = below ? row + half : 0;
            const std::uint32_t bottom = above ? row - std::min(row, half) : writable.height;
            const auto spot = ground.best_place(dark_offsets(target, blocks[i], scale), top, bottom, column);
            if (!spot) return std::nullopt;
            placed.push_back({blocks[i], *spot, scale});
        }
        return placed;
    };
    std::optional<std::vector<Placement>> best = at_scale(least);
    double fits = least, too_large = most;
    for (const Box& block : blocks)
        too_large = std::min({too_large, writable.width / block.width(), writable.height / block.height()});
    for (int i = 0; best && i < kHalvings && too_large > fits; ++i) {
        const double scale = 0.5 * (fits + too_large);
        if (auto found = at_scale(scale)) {
            best = std::move(found);
            fits = scale;
        } else {
            too_large = scale;
        }
    }
    return best;
}

}  // namespace orbweaver::inscription
