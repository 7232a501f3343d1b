#include "thread_kinds.hpp"

#include <numeric>

namespace orbweaver::inscription {

std::vector<std::uint32_t> threads_of(const WebAtRest& web, std::string_view kind) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < web.segments.size(); ++i)
        if (web.kinds[web.segments[i].kind] == kind) found.push_back(i);
    return found;
}

std::vector<std::uint32_t> next_outward(const WebAtRest& web) {
    std::vector<std::uint32_t> next(web.points.size());
    std::iota(next.begin(), next.end(), 0U);
    for (const std::uint32_t i : threads_of(web, "radius")) {
        const ThreadSegment& thread = web.segments[i];
        const double a = distance(web.points[thread.a], web.center),
                     b = distance(web.points[thread.b], web.center);
        if (a < b) next[thread.a] = thread.b;
        if (b < a) next[thread.b] = thread.a;
    }
    return next;
}

}  // namespace orbweaver::inscription
