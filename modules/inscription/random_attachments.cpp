// Figure 6.13 of the thesis: removal, and then threads between masses within the letters at random, darker than
// the rest of the spiral.

#include <algorithm>
#include <set>

#include "mode.hpp"
#include "score.hpp"
#include "source_picture.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kReach = 3;         ///< meshes, the longest thread that is attached
constexpr std::size_t kTries = 200;  ///< for each thread sought, at most

std::vector<std::uint32_t> points_within(const Writing& writing) {
    std::vector<std::uint32_t> within;
    const double side = writing.page.side;
    for (std::uint32_t i = 0; i < writing.web.points.size(); ++i) {
        const Spot spot = writing.page.spot(writing.web.points[i]);
        if (spot.x < 0 || spot.y < 0 || spot.x >= side || spot.y >= side) continue;
        if (writing.coverage.row(static_cast<std::uint32_t>(spot.y))[static_cast<std::uint32_t>(spot.x)] != 0)
            within.push_back(i);
    }
    return within;
}

}  // namespace

WebChange attach_at_random(const Writing& writing) {
    const WebAtRest& web = writing.web;
    WebChange change = remove_matches(writing);
    const std::vector<std::uint32_t> within = points_within(writing);
    if (change.removed.empty() || within.size() < 2) return change;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const ThreadSegment& thread : web.segments) joined.insert(std::minmax(thread.a, thread.b));
    const Bitmap source = source_picture(web, writing.page);
    const auto sought =
        static_cast<std::size_t>(writing.settings.attachments * static_cast<double>(change.removed.size()));
    std::uint64_t draws = 0;
    const auto any_of = [&](const std::vector<std::uint32_t>& list) {
        return list[static_cast<std::size_t>(writing.random.uniform(draws++) *
                                             static_cast<double>(list.size()))];
    };
    for (std::size_t tries = 0; change.added.size() < sought && tries < kTries * sought; ++tries) {
        const std::uint32_t a = any_of(within), b = any_of(within);
        const double length = distance(web.points[a], web.points[b]);
        if (!(length > 0) || length > kReach * writing.mesh) continue;
        const int score = match_score(source, writing.dilated, writing.page.spot(web.points[a]),
                                      writing.page.spot(web.points[b]));
        if (score > writing.settings.score_threshold && joined.insert(std::minmax(a, b)).second)
            change.added.push_back({a, b, any_of(change.removed), writing.settings.width});
    }
    return change;
}

}  // namespace orbweaver::inscription
