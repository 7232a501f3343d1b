#include "way_field.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace orbweaver::spider {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// A point that a wave reaches, and where it comes from: a point in the plane of what it crossed last.
struct Arrival {
    double distance = kNoWay;  // m
    Vec3 from;
};

/// At `place` in the triangle a b c, over its edge a b, whose ends the wave reached after `to_a` and `to_b` m.
Arrival across_edge(const Vec3& a, double to_a, const Vec3& b, double to_b, const Vec3& c,
                    const Vec3& place) noexcept {
    constexpr double kRounding = 1e-12;  // of the edge
    const double length = distance(a, b);
    if (!(length > 0) || to_a == kNoWay || to_b == kNoWay) return {};
    const Vec3 along = (b - a) / length;
    const Vec3 off = across(c - a, along);
    const double width = norm(off);
    if (!(width > 0)) return {};
    const Vec3 in = off / width;
    const double s_along = (to_a * to_a - to_b * to_b + length * length) / (2 * length);
    const double square = to_a * to_a - s_along * s_along;
    if (square < -kRounding * (to_a * to_a + length * length)) return {};
    // Where the wave comes along the edge, rounding may leave it on this side.
    const double depth = std::sqrt(std::max(0.0, square)), height = dot(place - a, in),
                 p_along = dot(place - a, along);
    if (!(depth + height > 0)) return {};
    const double crossing = s_along + (p_along - s_along) * depth / (depth + height);
    if (crossing < -kRounding * length || crossing > (1 + kRounding) * length) return {};
    const Vec3 source = a + s_along * along - depth * in;
    return {distance(source, place), source};
}

Arrival nearer(const Arrival& a, const Arrival& b) noexcept { return b.distance < a.distance ? b : a; }

/// The faces at each vertex, one after the other.
struct FacesAtVertices {
    std::vector<std::uint32_t> first, face;

    explicit FacesAtVertices(const Surface& surface) : first(surface.vertices().size() + 1) {
        const auto faces = surface.faces();
        for (const auto& corners : faces)
            for (const std::uint32_t v : corners) ++first[v + 1];
        for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
        face.resize(first.back());
        std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
        for (std::uint32_t f = 0; f < faces.size(); ++f)
            for (const std::uint32_t v : faces[f]) face[next[v]++] = f;
    }
};

}  // namespace

WayField::WayField(const Surface& surface, const SurfacePoint& target)
    : surface_(&surface),
      face_(target.face),
      target_(surface.position(target)),
      distance_(surface.vertices().size(), kNoWay) {
    using Front = std::pair<double, std::uint32_t>;
    const auto points = surface.vertices();
    const auto faces = surface.faces();
    const FacesAtVertices at(surface);
    std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
    const auto reach = [&](std::uint32_t v, double distance) {
        if (!(distance < distance_[v] * (1 - 1e-12))) return;  // by more than rounding
        distance_[v] = distance;
        front.emplace(distance, v);
    };
    for (const std::uint32_t v : faces[face_]) reach(v, distance(points[v], target_));
    while (!front.empty()) {
        const auto [passed, a] = front.top();
        front.pop();
        if (passed > distance_[a]) continue;
        for (std::uint32_t i = at.first[a]; i < at.first[a + 1]; ++i) {
            const auto& corners = faces[at.face[i]];
            const auto turn = std::find(corners.begin(), corners.end(), a) - corners.begin();
            const std::uint32_t b = corners[(turn + 1) % 3], c = corners[(turn + 2) % 3];
            for (const auto& [by, to] : {std::pair{b, c}, std::pair{c, b}}) {
                const Arrival over =
                    across_edge(points[a], distance_[a], points[by], distance_[by], points[to], points[to]);
                reach(to, std::min(over.distance, distance_[a] + distance(points[a], points[to])));
            }
        }
    }
}

Vec3 WayField::seen_from(const SurfacePoint& at) const noexcept {
    if (at.face == face_) return target_;
    const Vec3 here = surface_->position(at);
    const auto& corners = surface_->faces()[at.face];
    Arrival best;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
        const Vec3 &pa = surface_->vertices()[a], &pb = surface_->vertices()[b], &pc = surface_->vertices()[c];
        best = nearer(best, across_edge(pa, distance_[a], pb, distance_[b], pc, here));
        const double to_a = distance(here, pa);
        if (to_a > 0) best = nearer(best, {distance_[a] + to_a, pa});
    }
    const double off = distance(best.from, here);
    if (best.distance == kNoWay || !(off > 0)) return target_;
    return here + (best.distance / off) * (best.from - here);
}

bool WayField::leads_from(const SurfacePoint& at) const noexcept {
    return distance_[surface_->faces()[at.face][0]] != kNoWay;
}

std::vector<Vec3> shortest_way(const Surface& surface, const SurfacePoint& from, const SurfacePoint& to,
                               double step) {
    constexpr std::size_t kMost = 100'000;  // points
    const WayField field(surface, to);
    const Vec3 end = surface.position(to);
    std::vector<Vec3> points{surface.position(from)};
    SurfacePoint at = from;
    while (field.leads_from(at) && points.size() < kMost) {
        const Vec3 way = field.seen_from(at) - points.back();
        const double left = norm(way);
        if (left <= step) break;
        const SurfaceStep placed = surface.place(at, surface.normal(at.face), way);
        const SurfaceStep walked = surface.step(placed.end, step);
        if (placed.answer != Answer::found || walked.answer != Answer::found || walked.stop != StepStop::none)
            break;
        at = walked.end.at;
        points.push_back(walked.end.position);
    }
    points.push_back(end);
    return points;
}

}  // namespace orbweaver::spider
