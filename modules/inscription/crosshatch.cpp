// Figure 6.12 of the thesis: each mass of the spiral is joined to two more along it, beyond the one that it is
// joined to; of these threads those stay that match the target. The spiral itself stays whole.

#include <algorithm>
#include <set>

#include "mode.hpp"
#include "score.hpp"
#include "source_picture.hpp"
#include "thread_kinds.hpp"

namespace orbweaver::inscription {

namespace {

/// A thread from each mass of a turn to the second and third behind it.
std::vector<WebChange::Added> hatching(const WebAtRest& web) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const ThreadSegment& thread : web.segments) joined.insert(std::minmax(thread.a, thread.b));
    const std::vector<std::uint32_t> spiral = threads_of(web, "spiral");
    std::vector<WebChange::Added> added;
    for (std::size_t i = 0; i < spiral.size(); ++i)
        for (std::size_t beyond = i + 1; beyond < spiral.size() && beyond <= i + 2; ++beyond) {
            const ThreadSegment& last = web.segments[spiral[beyond]];
            if (web.segments[spiral[beyond - 1]].b != last.a) break;  // the spiral is laid in several walks
            const std::uint32_t from = web.segments[spiral[i]].a;
            if (from != last.b && joined.insert(std::minmax(from, last.b)).second)
                added.push_back({from, last.b, spiral[i], 1});
        }
    return added;
}

}  // namespace

WebChange crosshatch(const Writing& writing) {
    const WebAtRest& web = writing.web;
    WebChange change;
    change.added = hatching(web);
    const Bitmap source = source_picture(web, writing.page, change.added);
    std::erase_if(change.added, [&](const WebChange::Added& thread) {
        return match_score(source, writing.dilated, writing.page.spot(web.points[thread.a]),
                           writing.page.spot(web.points[thread.b])) <= writing.settings.score_threshold;
    });
    return change;
}

}  // namespace orbweaver::inscription
