#include <algorithm>

#include "construction.hpp"

namespace orbweaver::web {

namespace {

/// `p` moved towards `center` by `amount`, but never past half its way.
Vec3 moved_towards(const Vec3& p, const Vec3& center, double amount) {
    const double way = distance(p, center);
    return p + (center - p) * (std::min(amount, way / 2) / way);
}

/// A thread under an even pull across it hangs in a parabola: 4 s t (1 - t) of the segment's length L.
void pull_inward(const Site& site, double sag, std::span<const Index> segment, Layout& layout) {
    const Vec3 from = layout.positions[segment.front()];
    const double length = distance(from, layout.positions[segment.back()]);
    for (const Index i : segment.subspan(1, segment.size() - 2)) {
        Vec3& p = layout.positions[i];
        const double t = distance(p, from) / length;
        p = moved_towards(p, site.center, 4 * sag * t * (1 - t) * length);
    }
}

}  // namespace

void lay_frame(const Site& site, const Construction& how, Jitter& jitter, Layout& layout) {
    std::vector<Index> inner;
    for (const Vec3& anchor : site.anchors) {
        const Index outer = add_particle(layout, anchor, true);
        inner.push_back(add_particle(layout, moved_towards(anchor, site.center, how.move_outer), false));
        lay_strand(layout, outer, inner.back(), Kind::anchor, how.outer_frame.placement, 1, jitter);
    }
    for (std::size_t i = 0; i < inner.size(); ++i) {
        // Two pieces at least: a segment needs a middle mass for its primary spoke.
        const std::vector<Index> segment = lay_strand(layout, inner[i], inner[(i + 1) % inner.size()],
                                                      Kind::frame, how.inner_frame.placement, 2, jitter);
        pull_inward(site, how.inward_pull, segment, layout);
        layout.corners.push_back(layout.frame.size());
        layout.frame.insert(layout.frame.end(), segment.begin(), segment.end() - 1);
    }
}

}  // namespace orbweaver::web
