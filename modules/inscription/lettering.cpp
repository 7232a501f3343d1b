#include "lettering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ink.hpp"
#include "low_pass.hpp"
#include "orbweaver/fault.hpp"
#include "placing.hpp"
#include "thread_kinds.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kGroundPixels = 2;    ///< to a mesh, of the raster on which a place is sought
constexpr double kFinestGround = 400;  ///< pixels of its side
constexpr float kBare = 0.5F;          ///< of the spiral's usual ink: where it has less, nothing can be written
constexpr float kCrowded = 1.7F;       ///< of that: where all threads have more, letters do not stand out
constexpr double kLeastHeight = 3;     ///< meshes: lower blocks cannot be read
constexpr double kMostHeight = 20;     ///< meshes: higher ones are read no better, and crowd hub and frame

float median_above(const Shades& shades, float least) {
    std::vector<float> some;
    for (const float each : shades.values)
        if (each > least) some.push_back(each);
    if (some.empty()) return 0;
    std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2), some.end());
    return some[some.size() / 2];
}

/// Where the spiral is about as dense as it usually is, and radii do not crowd.
Bitmap writable_ground(const WebAtRest& web, const Page& page, double blur) {
    std::vector<ThreadSegment> spiral;
    for (const std::uint32_t i : threads_of(web, "spiral")) spiral.push_back(web.segments[i]);
    const Shades turns = low_pass(ink(web.points, spiral, page), blur);
    const Shades all = low_pass(ink(web.points, web.segments, page), blur);
    const float usual = median_above(turns, 0.1F * *std::max_element(turns.values.begin(), turns.values.end()));
    Bitmap ground(page.side, page.side);
    for (std::size_t i = 0; i < ground.values.size(); ++i)
        ground.values[i] = turns.values[i] > kBare * usual && all.values[i] < kCrowded * usual ? 1 : 0;
    return ground;
}

/// Silk of threads a pixel, where it is to be written.
double mean_ink(const Shades& seen, const Bitmap& ground) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < ground.values.size(); ++i) {
        sum += static_cast<double>(ground.values[i]) * seen.values[i];
        count += ground.values[i];
    }
    return count > 0 ? sum / count : 0;
}

double dark_pixels(const Target& target, const std::vector<Box>& blocks) {
    double count = 0;
    for (const Box& block : blocks)
        for (std::uint32_t y = block.top; y < block.bottom; ++y)
            for (std::uint32_t x = block.left; x < block.right; ++x)
                count += target.coverage[target.index(x, y)];
    return count;
}

std::vector<Placement> best_place(const WebAtRest& web, const Target& target, const Page& page,
                                  const WhereToWrite& where) {
    const double extent = page.pixel * page.side;
    const double side = std::clamp(std::ceil(kGroundPixels * extent / web.mesh_width), 16.0, kFinestGround);
    const Page coarse{page.middle, page.right, page.up, extent / side, static_cast<std::uint32_t>(side)};
    const double mesh = web.mesh_width / coarse.pixel;
    const Shades seen = ink(web.points, web.segments, coarse);
    const Bitmap ground = writable_ground(web, coarse, mesh);
    const auto blocks = blocks_of(target, where.lines);
    if (blocks.empty()) return {};
    double width = 0, height = 0;
    for (const Box& block : blocks) {
        width = std::max(width, block.width());
        height = std::max(height, block.height());
    }
    double all_silk = 0;
    for (const float each : seen.values) all_silk += each;
    const double least = kLeastHeight * mesh / height;
    const double affordable =
        std::sqrt(where.most_ink * all_silk / (mean_ink(seen, ground) * dark_pixels(target, blocks)));
    const double most = std::clamp(std::min(affordable, kMostHeight * mesh / height), least,
                                   std::max(least, std::min(side / width, side / height)));
    auto placed = best_placements(target, blocks, ground, coarse.spot(web.center), least, most);
    if (!placed)
        throw Fault(FaultKind::invalid,
                    fmt::format("what is to be written does not fit on the spiral: not even {:.3g} m high ({} "
                                "meshes); write less, use more lines, or give 'position' and 'size'",
                                kLeastHeight * web.mesh_width, kLeastHeight));
    const double finer = static_cast<double>(page.side) / side;
    for (Placement& each : *placed)
        each = {each.block, {each.middle.x * finer, each.middle.y * finer}, each.scale * finer};
    return *placed;
}

}  // namespace

Lettering lay_on(const WebAtRest& web, const Target& target, const WhereToWrite& where) {
    if (!(web.mesh_width > 0))
        throw Fault(FaultKind::invalid,
                    "the web has no spiral to write in; expected an orb web with two turns at least");
    Lettering lettering{page_of(web, where.side), {}, {}, where.blur * web.mesh_width};
    const Page& page = lettering.page;
    std::vector<Placement> placed;
    if (where.best_place && !where.position && !where.size) {
        placed = best_place(web, target, page, where);
    } else {
        const Spot middle =
            where.position ? page.spot(web.center + where.position->x * web.right + where.position->y * web.up)
                           : Spot{0.5 * page.side, 0.5 * page.side};
        placed = {whole(target, middle, where.size ? *where.size / page.pixel : page.side)};
    }
    lettering.coverage = place(target, placed, page.side);
    for (const Placement& each : placed) {
        lettering.cut += dark_beside(target, each, page.side);
        const Box block = dark_box(lettering.coverage.values, page.side, box_of(each, page.side));
        if (!block.empty()) lettering.blocks.push_back(block);
    }
    if (lettering.blocks.empty())
        throw Fault(FaultKind::invalid,
                    "nothing of what is to be written lies on the web; give another 'position' or 'size'");
    return lettering;
}

}  // namespace orbweaver::inscription
