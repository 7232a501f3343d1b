#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>
#include <vector>

#include "dilate.hpp"
#include "mode.hpp"
#include "orbweaver/contracts/inscriber.hpp"
#include "orbweaver/random.hpp"
#include "page.hpp"
#include "target.hpp"

namespace orbweaver::test {

enum Kind : std::uint32_t { kAnchor, kFrame, kRadius, kHub, kSpiral, kStrand };
inline constexpr std::array<std::string_view, 6> kKinds = {"anchor", "frame",  "radius",
                                                           "hub",    "spiral", "strand"};

/// A web laid by hand, which WebAtRest is a view of.
struct HandMade {
    std::vector<Vec3> points;
    std::vector<ThreadSegment> segments;
    std::vector<double> tension;
    Vec3 center{}, right{1, 0, 0}, up{0, 1, 0};
    double mesh = 0;

    void join(std::uint32_t a, std::uint32_t b, std::uint32_t kind, double width = 1) {
        segments.push_back({a, b, kind, static_cast<float>(width)});
        tension.push_back(1);
    }
    WebAtRest at_rest() const { return {points, segments, tension, kKinds, center, right, up, mesh, 0}; }
    operator WebAtRest() const { return at_rest(); }
};

inline constexpr std::uint32_t kHubMeshes = 3;  ///< radius of an orb's hub

/// Radii with points at equal distances, from the hub's ring to the frame; between them rings of spiral, each
/// closed, in order outward. Point k (n + 2) + i is the i-th of radius k, of n turns; i = 0 is on the hub.
inline HandMade make_orb(std::uint32_t radii, std::uint32_t turns, double mesh = 0.01) {
    HandMade orb;
    orb.mesh = mesh;
    orb.center = {0.3, 1.2, -0.1};
    const std::uint32_t rings = turns + 2;
    for (std::uint32_t k = 0; k < radii; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.25) / radii;
        for (std::uint32_t i = 0; i < rings; ++i) {
            const double from_hub = (kHubMeshes + i) * mesh;
            orb.points.push_back(orb.center + from_hub * std::cos(angle) * orb.right +
                                 from_hub * std::sin(angle) * orb.up);
        }
    }
    for (std::uint32_t k = 0; k < radii; ++k)
        for (std::uint32_t i = 0; i + 1 < rings; ++i) orb.join(k * rings + i, k * rings + i + 1, kRadius);
    for (std::uint32_t i = 0; i < rings; ++i) {
        const Kind kind = i == 0 ? kHub : (i + 1 == rings ? kFrame : kSpiral);
        for (std::uint32_t k = 0; k < radii; ++k) orb.join(k * rings + i, (k + 1) % radii * rings + i, kind);
    }
    return orb;
}

/// Threads strewn over a square of 1 m, of all kinds by turns.
inline HandMade random_web(std::uint32_t points, std::uint32_t threads, std::uint64_t seed) {
    HandMade web;
    web.mesh = 0.05;
    const RandomStream random(seed, "web");
    std::uint64_t n = 0;
    for (std::uint32_t i = 0; i < points; ++i) {
        const double x = random.uniform(n++), y = random.uniform(n++);
        web.points.push_back({x, y, 0});
    }
    for (std::uint32_t i = 0; i < threads; ++i) {
        const auto a = static_cast<std::uint32_t>(random.bits(n++) % points);
        const auto b = static_cast<std::uint32_t>(random.bits(n++) % points);
        web.join(a, b, i % kKinds.size(), random.uniform(n++, 0.5, 3));
    }
    return web;
}

/// The web once it is changed, nothing having moved: threads that stay in their order, those thickened cut in
/// place, then those added.
inline HandMade changed(const HandMade& plain, const WebChange& change) {
    HandMade web = plain;
    web.segments.clear();
    web.tension.clear();
    for (std::uint32_t i = 0; i < plain.segments.size(); ++i) {
        if (std::find(change.removed.begin(), change.removed.end(), i) != change.removed.end()) continue;
        const ThreadSegment& thread = plain.segments[i];
        double at = 0;
        std::uint32_t from = thread.a;
        const auto lay = [&](double to, double width) {
            std::uint32_t end = thread.b;
            if (to < 1) {
                end = static_cast<std::uint32_t>(web.points.size());
                web.points.push_back(plain.points[thread.a] +
                                     to * (plain.points[thread.b] - plain.points[thread.a]));
            }
            web.join(from, end, thread.kind, width * thread.width);
            from = end;
            at = to;
        };
        for (const WebChange::Thickened& part : change.thickened) {
            if (part.segment != i) continue;
            if (part.from > at) lay(part.from, 1);
            lay(part.to, part.width);
        }
        if (at < 1) lay(1, 1);
    }
    for (const WebChange::Added& thread : change.added)
        web.join(thread.a, thread.b, plain.segments[thread.like].kind,
                 thread.width * plain.segments[thread.like].width);
    return web;
}

/// All that a mode is given.
struct Task {
    const HandMade& web;
    inscription::Page page;
    inscription::Bitmap coverage;
    inscription::ModeSettings settings{};
    std::uint64_t seed = 1;

    WebChange write(WebChange (*mode)(const inscription::Writing&)) const {
        const WebAtRest at_rest = web;
        return mode({at_rest, page, coverage, inscription::dilate(coverage, inscription::kDilation), web.mesh,
                     web.mesh, settings, RandomStream(seed, "attachments")});
    }
};

}  // namespace orbweaver::test
