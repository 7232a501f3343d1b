#include "study/query_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace orbweaver::study {

namespace {

using Real = long double;

struct Wide {
    Real x, y, z;
};

Wide wide(const Vec3& v) { return {v.x, v.y, v.z}; }
Vec3 narrow(const Wide& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
Wide operator-(const Wide& a, const Wide& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Wide operator+(const Wide& a, const Wide& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Wide operator*(Real s, const Wide& a) { return {s * a.x, s * a.y, s * a.z}; }
Real dot(const Wide& a, const Wide& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Wide cross(const Wide& a, const Wide& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

using Corners = std::array<std::uint32_t, 3>;

constexpr Real kOpen = 1e-11L;     ///< of a weight: nearer to an edge, rounding of doubles may decide otherwise
constexpr Real kTogether = 1e-9L;  ///< of the distance: crossings that are one place

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // the lower vertex first

struct Meeting {
    Real at;  ///< along the ray, m
    bool front;
    std::vector<Edge> open;  ///< edges to which the ray comes so near that rounding may decide
};

/// On which side the ray passes an edge: six times the volume of the tetrahedron that the two span. The same
/// number, with its sign turned, for the face on the other side.
Real side_of(const Wide& direction, const std::array<Wide, 3>& p, const Corners& corner, std::size_t edge) {
    const std::size_t next = (edge + 1) % 3;
    const bool turned = corner[edge] > corner[next];
    const Real volume =
        turned ? dot(direction, cross(p[next], p[edge])) : dot(direction, cross(p[edge], p[next]));
    return turned ? -volume : volume;
}

/// `p`: the corners as seen from the ray's origin.
std::optional<Meeting> meet(const Wide& direction, const std::array<Wide, 3>& p, const Corners& corner) {
    const std::array<Real, 3> sides = {side_of(direction, p, corner, 0), side_of(direction, p, corner, 1),
                                       side_of(direction, p, corner, 2)};
    const Real sum = sides[0] + sides[1] + sides[2];
    if (sum == 0) return std::nullopt;
    const Real margin = std::min({sides[0] / sum, sides[1] / sum, sides[2] / sum});
    if (margin < -kOpen) return std::nullopt;
    const Wide normal = cross(p[1] - p[0], p[2] - p[0]);
    Meeting meeting{dot(normal, p[0]) / dot(normal, direction), sum > 0, {}};
    for (std::size_t edge = 0; edge < 3; ++edge)
        if (sides[edge] / sum <= kOpen)
            meeting.open.push_back(std::minmax({corner[edge], corner[(edge + 1) % 3]}));
    return meeting;
}

/// Whether a ray cannot pass by these faces, which it meets in one place: some face is met well within, or all
/// turn the same side to it and each goes on into another one beyond the edges that are open.
bool is_solid(std::span<const Meeting> place) {
    const auto is_shared = [&](const Edge& edge) {
        return std::count_if(place.begin(), place.end(), [&](const Meeting& m) {
                   return std::find(m.open.begin(), m.open.end(), edge) != m.open.end();
               }) > 1;
    };
    return std::any_of(place.begin(), place.end(), [](const Meeting& m) { return m.open.empty(); }) ||
           std::all_of(place.begin(), place.end(), [&](const Meeting& m) {
               return m.front == place[0].front && std::all_of(m.open.begin(), m.open.end(), is_shared);
           });
}

/// Whether a triangle is farther from a line than it is long, seen from its first corner: in doubles, with room
/// for their rounding. Spares asking most of them in extended precision.
bool is_beside(const Vec3& a, const Vec3& b, const Vec3& c, const Stance& question) {
    const Vec3 from = a - question.position, off = cross(from, question.up);
    const double longest = std::max(dot(b - a, b - a), dot(c - a, c - a));
    return dot(off, off) > 1.001 * longest + 1e-20 * dot(from, from);
}

Wide nearest_on_segment(const Wide& a, const Wide& b, const Wide& q) {
    const Real along = dot(q - a, b - a) / dot(b - a, b - a);
    return a + std::clamp(along, Real{0}, Real{1}) * (b - a);
}

Wide nearest_on_triangle(const std::array<Wide, 3>& p, const Wide& q) {
    const Wide normal = cross(p[1] - p[0], p[2] - p[0]);
    const Wide foot = q - (dot(q - p[0], normal) / dot(normal, normal)) * normal;
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i)
        inside = inside && dot(cross(p[(i + 1) % 3] - p[i], foot - p[i]), normal) >= 0;
    if (inside) return foot;
    Wide best = nearest_on_segment(p[0], p[1], q);
    for (std::size_t i = 1; i < 3; ++i)
        if (const Wide other = nearest_on_segment(p[i], p[(i + 1) % 3], q);
            dot(other - q, other - q) < dot(best - q, best - q))
            best = other;
    return best;
}

}  // namespace

QueryTruth QueryReference::crossing(const Stance& question) const {
    const auto vertices = surface_.vertices();
    const Wide origin = wide(question.position), direction = wide(-question.up);
    std::vector<Meeting> met;
    for (const Corners& corner : surface_.faces()) {
        if (is_beside(vertices[corner[0]], vertices[corner[1]], vertices[corner[2]], question)) continue;
        const std::array<Wide, 3> p = {wide(vertices[corner[0]]) - origin, wide(vertices[corner[1]]) - origin,
                                       wide(vertices[corner[2]]) - origin};
        const auto meeting = meet(direction, p, corner);
        if (meeting && meeting->at >= 0 && meeting->at <= question.reach) met.push_back(*meeting);
    }
    std::sort(met.begin(), met.end(), [](const Meeting& a, const Meeting& b) { return a.at < b.at; });
    QueryTruth truth;
    for (std::size_t first = 0; first < met.size() && !truth.certain;) {
        std::size_t end = first;
        while (end < met.size() && met[end].at - met[first].at <= kTogether * met[first].at) ++end;
        const std::span place(met.data() + first, end - first);
        for (const Meeting& m : place) truth.places.push_back(narrow(origin + m.at * direction));
        truth.certain = is_solid(place);
        first = end;
    }
    return truth;
}

QueryTruth QueryReference::nearest(const Stance& question) const {
    const auto vertices = surface_.vertices();
    const Wide from = wide(question.position);
    Real least = static_cast<Real>(question.reach) * question.reach;
    QueryTruth truth;
    for (const Corners& corner : surface_.faces()) {
        const Wide at = nearest_on_triangle(
            {wide(vertices[corner[0]]), wide(vertices[corner[1]]), wide(vertices[corner[2]])}, from);
        const Real square = dot(at - from, at - from);
        if (square > least) continue;
        least = square;
        truth = {{narrow(at)}, true};
    }
    return truth;
}

}  // namespace orbweaver::study
