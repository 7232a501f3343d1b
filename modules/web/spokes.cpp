#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "construction.hpp"

namespace orbweaver::web {

namespace {

constexpr double kLargestHub = 0.25;  // of the way to the nearest frame mass
constexpr double kHubSpacing = 0.1;   // of the hub's radius: arms nearer than that share a hub mass

/// A primary spoke: places in Layout::frame that a straight way through the hub joins.
struct Chord {
    std::size_t middle = 0;
    std::size_t farthest = 0;
};

std::size_t farthest_from(const Layout& layout, std::size_t from) {
    constexpr double kTie = 1 + 1e-9;  // of symmetric masses the first is taken, whatever the rounding
    const Vec3& p = layout.positions[layout.frame[from]];
    std::size_t best = from;
    double longest = 0;
    for (std::size_t i = 0; i < layout.frame.size(); ++i) {
        const double way = distance(p, layout.positions[layout.frame[i]]);
        if (way <= longest * kTie) continue;
        longest = way;
        best = i;
    }
    return best;
}

std::vector<Chord> primary_chords(const Layout& layout) {
    std::vector<Chord> chords;
    for (std::size_t s = 0; s < layout.corners.size(); ++s) {
        const std::size_t begin = layout.corners[s];
        const std::size_t end = s + 1 < layout.corners.size() ? layout.corners[s + 1] : layout.frame.size();
        const std::size_t middle = begin + (end - begin) / 2;
        const Chord chord{middle, farthest_from(layout, middle)};
        const bool laid = std::any_of(chords.begin(), chords.end(), [&](const Chord& other) {
            return other.middle == chord.farthest && other.farthest == chord.middle;
        });
        if (!laid) chords.push_back(chord);
    }
    return chords;
}

bool sees_whole_frame(const Layout& layout, const PlanePoint& p) {
    const std::size_t n = layout.frame.size();
    for (std::size_t i = 0; i < n; ++i) {
        const PlanePoint a = layout.plane.project(layout.positions[layout.frame[i]]);
        const PlanePoint b = layout.plane.project(layout.positions[layout.frame[(i + 1) % n]]);
        if (turn(p, a, b) <= 0) return false;
    }
    return true;
}

/// The point of least squared distance to the primary chords, where it sees the whole frame.
std::optional<PlanePoint> intersection(const Layout& layout, std::span<const Chord> chords) {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0;
    for (const Chord& chord : chords) {
        const PlanePoint a = layout.plane.project(layout.positions[layout.frame[chord.middle]]);
        const PlanePoint b = layout.plane.project(layout.positions[layout.frame[chord.farthest]]);
        const PlanePoint n{a.y - b.y, b.x - a.x};  // longer chords weigh more
        const double offset = n.x * a.x + n.y * a.y;
        xx += n.x * n.x;
        xy += n.x * n.y;
        yy += n.y * n.y;
        x += n.x * offset;
        y += n.y * offset;
    }
    const double determinant = xx * yy - xy * xy;
    if (determinant <= 1e-3 * xx * yy) return std::nullopt;  // nearly parallel
    const PlanePoint p{(yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant};
    if (!sees_whole_frame(layout, p)) return std::nullopt;
    return p;
}

Vec3 hub_center(const Site& site, const Layout& layout, std::span<const Chord> chords) {
    if (site.center_given) return site.center;
    const auto p = intersection(layout, chords);
    return p ? site.plane.lift(*p) : site.center;
}

double hub_radius(const Layout& layout, double asked) {
    double nearest = asked / kLargestHub;
    for (const Index i : layout.frame)
        nearest = std::min(nearest, distance(layout.center, layout.positions[i]));
    return nearest * kLargestHub;
}

/// The hub mass of every primary arm, by its place in the frame. Places come in order around, so the
/// ring's masses do too.
using Arms = std::map<std::size_t, Index>;

Arms lay_hub_masses(std::span<const Chord> chords, double radius, Layout& layout) {
    std::set<std::size_t> places;
    for (const Chord& chord : chords) places.insert({chord.middle, chord.farthest});
    Arms arms;
    const auto is_near = [&](const Vec3& p, Index hub) {
        return distance(p, layout.positions[hub]) < kHubSpacing * radius;
    };
    for (const std::size_t place : places) {
        const Vec3 way = layout.positions[layout.frame[place]] - layout.center;
        const Vec3 p = layout.center + way * (radius / norm(way));
        if (!layout.hub.empty() && is_near(p, layout.hub.back()))
            arms[place] = layout.hub.back();
        else if (!layout.hub.empty() && is_near(p, layout.hub.front()))
            arms[place] = layout.hub.front();
        else
            layout.hub.push_back(arms[place] = add_particle(layout, p, false));
    }
    return arms;
}

/// The ring, and each primary spoke's way across it.
void lay_hub_threads(std::span<const Chord> chords, const Arms& arms, double placement, Layout& layout) {
    std::set<std::pair<Index, Index>> joined;
    Jitter even(RandomStream(0, ""), 0);
    const auto join = [&](Index a, Index b) {
        if (a == b || !joined.insert(std::minmax(a, b)).second) return;
        lay_strand(layout, a, b, Kind::hub, placement, 1, even);
    };
    for (std::size_t i = 0; i < layout.hub.size(); ++i)
        join(layout.hub[i], layout.hub[(i + 1) % layout.hub.size()]);
    for (const Chord& chord : chords) join(arms.at(chord.middle), arms.at(chord.farthest));
}

Index nearest_hub_mass(const Layout& layout, const Vec3& p) {
    return *std::min_element(layout.hub.begin(), layout.hub.end(), [&](Index a, Index b) {
        return distance(layout.positions[a], p) < distance(layout.positions[b], p);
    });
}

}  // namespace

void lay_spokes(const Site& site, const Construction& how, Jitter& jitter, Layout& layout) {
    const std::vector<Chord> chords = primary_chords(layout);
    layout.center = hub_center(site, layout, chords);
    const Arms arms = lay_hub_masses(chords, hub_radius(layout, how.hub_radius), layout);
    lay_hub_threads(chords, arms, how.spokes.placement, layout);
    for (std::size_t place = 0; place < layout.frame.size(); ++place) {
        const Index from = layout.frame[place];
        const auto arm = arms.find(place);
        const Index to = arm != arms.end() ? arm->second : nearest_hub_mass(layout, layout.positions[from]);
        layout.spokes.push_back(lay_strand(layout, from, to, Kind::radius, how.spokes.placement, 1, jitter));
    }
}

}  // namespace orbweaver::web
