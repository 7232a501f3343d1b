#include "layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/fault.hpp"

namespace orbweaver::web {

namespace {

[[noreturn]] void too_many() {
    throw Fault(FaultKind::limit,
                fmt::format("the web would have more than {} particles; lay its masses farther apart (the "
                            "'placement' of inner_frame, outer_frame, spokes or strand) or hang it smaller",
                            kMostParticles));
}

}  // namespace

Index add_particle(Layout& layout, const Vec3& position, bool fixed) {
    if (layout.positions.size() >= kMostParticles) too_many();
    layout.positions.push_back(position);
    layout.fixed.push_back(fixed ? 1 : 0);
    return static_cast<Index>(layout.positions.size() - 1);
}

std::vector<Index> lay_strand(Layout& layout, Index from, Index to, Kind kind, double placement,
                              std::size_t least, Jitter& jitter) {
    const Vec3 start = layout.positions[from];
    const Vec3 way = layout.positions[to] - start;
    const double wanted = std::round(norm(way) / placement);
    if (!(wanted < static_cast<double>(kMostParticles))) too_many();
    const std::size_t pieces = std::max(least, static_cast<std::size_t>(wanted));
    std::vector<Index> particles = {from};
    for (std::size_t i = 1; i < pieces; ++i) {
        const double t = (static_cast<double>(i) + jitter.draw()) / static_cast<double>(pieces);
        particles.push_back(add_particle(layout, start + way * t, false));
    }
    particles.push_back(to);
    for (std::size_t i = 0; i < pieces; ++i) layout.pieces.push_back({particles[i], particles[i + 1], kind});
    return particles;
}

}  // namespace orbweaver::web
