// Figure 6.13 of the thesis: removal, and then threads between masses within the letters at random, darker than
// the rest of the spiral.

#include <algorithm>
#include <set>

#include "mode.hpp"
#include "score.hpp"
#include "source_picture.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kReach = 5;        ///< meshes, the longest thread that is attached
constexpr std::size_t kTries = 20;  ///< for each thread sought, at most

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

std::vector<Spot> dark_pixels(const Bitmap& coverage) {
    std::vector<Spot> dark;
    for (std::uint32_t y = 0; y < coverage.height; ++y)
        for (std::uint32_t x = 0; x < coverage.width; ++x)
            if (coverage.row(y)[x] != 0) dark.push_back({x + 0.5, y + 0.5});
    return dark;
}

std::uint32_t nearest_to(const Writing& writing, const std::vector<std::uint32_t>& points, const Spot& spot) {
    const Vec3 place = writing.page.point(spot);
    return *std::min_element(points.begin(), points.end(), [&](std::uint32_t a, std::uint32_t b) {
        return distance(writing.web.points[a], place) < distance(writing.web.points[b], place);
    });
}

/// Those of some points that are within reach (m) of one of them, itself included.
std::vector<std::uint32_t> around(const WebAtRest& web, const std::vector<std::uint32_t>& points,
                                  std::uint32_t middle, double reach) {
    std::vector<std::uint32_t> near;
    for (const std::uint32_t each : points)
        if (distance(web.points[each], web.points[middle]) <= reach) near.push_back(each);
    return near;
}

}  // namespace

WebChange attach_at_random(const Writing& writing) {
    const WebAtRest& web = writing.web;
    WebChange change = remove_matches(writing);
    const std::vector<std::uint32_t> within = points_within(writing);
    const std::vector<Spot> letters = dark_pixels(writing.coverage);
    if (change.removed.empty() || within.empty()) return change;
    std::set<std::pair<std::uint32_t, std::uint32_t>> joined;
    for (const ThreadSegment& thread : web.segments) joined.insert(std::minmax(thread.a, thread.b));
    const Bitmap source = source_picture(web, writing.page);
    const auto sought =
        static_cast<std::size_t>(writing.settings.attachments * static_cast<double>(change.removed.size()));
    std::uint64_t draws = 0;
    const auto any_of = [&](const auto& list) {
        return list[static_cast<std::size_t>(writing.random.uniform(draws++) *
                                             static_cast<double>(list.size()))];
    };
    for (std::size_t tries = 0; change.added.size() < sought && tries < kTries * sought; ++tries) {
        // By a place in the letters, not by a mass: masses crowd about the hub.
        const std::uint32_t a = nearest_to(writing, within, any_of(letters));
        const std::uint32_t b = any_of(around(web, within, a, kReach * writing.mesh));
        const int score = match_score(source, writing.dilated, writing.page.spot(web.points[a]),
                                      writing.page.spot(web.points[b]));
        if (a != b && score > writing.settings.score_threshold && joined.insert(std::minmax(a, b)).second)
            change.added.push_back({a, b, any_of(change.removed), writing.settings.width});
    }
    return change;
}

}  // namespace orbweaver::inscription
