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

constexpr double kGroundPixels = 2;   ///< to a mesh, of the raster on which a place is sought
constexpr double kFinestGround = 400;  ///< pixels of its side
constexpr double kBare = 0.5;          ///< of the usual ink: where there is less, nothing can be written
constexpr double kLeastHeight = 3;     ///< meshes: lower blocks cannot be read

/// Where the spiral is about as dense as it usually is.
Bitmap writable_ground(const WebAtRest& web, const Page& page, double blur) {
    std::vector<ThreadSegment> spiral;
    for (const std::uint32_t i : threads_of(web, "spiral")) spiral.push_back(web.segments[i]);
    const Shades seen = low_pass(ink(web.points, spiral, page), blur);
    std::vector<float> some;
    const float most = *std::max_element(seen.values.begin(), seen.values.end());
    for (const float each : seen.values)
        if (each > 0.1F * most) some.push_back(each);
    Bitmap ground(page.side, page.side);
    if (some.empty()) return ground;
    std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2), some.end());
    const float least = static_cast<float>(kBare) * some[some.size() / 2];
    for (std::size_t i = 0; i < seen.values.size(); ++i) ground.values[i] = seen.values[i] >= least ? 1 : 0;
    return ground;
}

std::vector<Placement> best_place(const WebAtRest& web, const Target& target, const Page& page, std::size_t lines) {
    const double extent = page.pixel * page.side;
    const double side = std::clamp(std::ceil(kGroundPixels * extent / web.mesh_width), 16.0, kFinestGround);
    const Page coarse{page.middle, page.right, page.up, extent / side, static_cast<std::uint32_t>(side)};
    const double mesh = web.mesh_width / coarse.pixel;
    const Bitmap ground = writable_ground(web, coarse, mesh);
    const auto blocks = blocks_of(target, lines);
    if (blocks.empty()) return {};
    double height = 0;
    for (const Block& block : blocks) height = std::max(height, block.height());
    auto placed = best_placements(target, blocks, ground, coarse.spot(web.center), kLeastHeight * mesh / height);
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
    Lettering lettering{page_of(web, where.side), {}, where.blur * web.mesh_width};
    const Page& page = lettering.page;
    if (where.best_place && !where.position && !where.size) {
        lettering.coverage = place(target, best_place(web, target, page, where.lines), page.side);
    } else {
        const Spot middle = where.position ? page.spot(web.center + where.position->x * web.right +
                                                       where.position->y * web.up)
                                           : Spot{0.5 * page.side, 0.5 * page.side};
        const double width = where.size ? *where.size / page.pixel : page.side;
        lettering.coverage = place(target, {whole(target, middle, width)}, page.side);
    }
    const auto& dark = lettering.coverage.values;
    if (std::find(dark.begin(), dark.end(), 1) == dark.end())
        throw Fault(FaultKind::invalid,
                    "nothing of what is to be written lies on the web; give another 'position' or 'size'");
    return lettering;
}

}  // namespace orbweaver::inscription
