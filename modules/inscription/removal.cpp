// The method of the thesis (6, figures 6.2 to 6.9): each spiral segment is scored against the target, and those
// above the threshold are taken.

#include "mode.hpp"
#include "score.hpp"
#include "source_picture.hpp"
#include "thread_kinds.hpp"

namespace orbweaver::inscription {

WebChange remove_matches(const Writing& writing) {
    const WebAtRest& web = writing.web;
    const Bitmap source = source_picture(web, writing.page);
    WebChange change;
    for (const std::uint32_t i : threads_of(web, "spiral")) {
        const Spot a = writing.page.spot(web.points[web.segments[i].a]);
        const Spot b = writing.page.spot(web.points[web.segments[i].b]);
        if (match_score(source, writing.dilated, a, b) > writing.settings.score_threshold)
            change.removed.push_back(i);
    }
    return change;
}

}  // namespace orbweaver::inscription
