// Figure 6.14 of the thesis: removal, and then denser threads around the letters.

#include <algorithm>
#include <cmath>

#include "dilate.hpp"
#include "mode.hpp"
#include "thread_parts.hpp"

namespace orbweaver::inscription {

namespace {

/// What lies beside the dilated letters, `width` pixels wide at most.
Bitmap ring_around(const Bitmap& dilated, double width) {
    const double widest = dilated.width;
    const auto reach = static_cast<std::uint32_t>(std::ceil(std::min(width, widest)));
    Bitmap ring = dilate(dilated, 2 * reach + 1);
    for (std::size_t i = 0; i < ring.values.size(); ++i) ring.values[i] &= dilated.values[i] ^ 1;
    return ring;
}

}  // namespace

WebChange strengthen_outline(const Writing& writing) {
    const WebAtRest& web = writing.web;
    WebChange change = remove_matches(writing);
    std::vector<std::uint8_t> taken(web.segments.size(), 0);
    for (const std::uint32_t i : change.removed) taken[i] = 1;
    const double mesh = writing.mesh / writing.page.pixel;
    const Bitmap ring = ring_around(writing.dilated, writing.settings.outline * mesh);
    for (std::uint32_t i = 0; i < web.segments.size(); ++i) {
        if (taken[i] != 0) continue;
        const Spot a = writing.page.spot(web.points[web.segments[i].a]);
        const Spot b = writing.page.spot(web.points[web.segments[i].b]);
        for (const Part& part : dark_parts(ring, a, b, kShortestPart * mesh))
            change.thickened.push_back({i, part.from, part.to, writing.settings.width});
    }
    return change;
}

}  // namespace orbweaver::inscription
