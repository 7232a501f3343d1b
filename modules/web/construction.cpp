#include "construction.hpp"

namespace orbweaver::web {

Layout construct(const Site& site, const Construction& how, const RandomStream& stream) {
    Jitter jitter(stream, how.irregularity);
    Layout layout;
    layout.plane = site.plane;
    lay_frame(site, how, jitter, layout);
    lay_spokes(site, how, jitter, layout);
    lay_spiral(how, layout);
    return layout;
}

}  // namespace orbweaver::web
