#include "underfoot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "walker.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

using mesh::SurfaceMesh;

namespace {

constexpr int kMostSteps = 32;            // of the walk: further off the rings or the tree find it sooner
constexpr int kRings = 2;                 // around the last face
constexpr std::size_t kMostAround = 256;  // faces of those rings

bool is_sound(const Stance& stance) noexcept {
    const auto nothing = [](const Vec3& v) { return 0 * (v.x + v.y + v.z); };  // NaN for what is not finite
    return nothing(stance.position) + nothing(stance.up) + nothing(stance.forward) == 0 &&
           stance.up != Vec3{} && (stance.side == 1 || stance.side == -1) && stance.reach >= 0;
}

/// sin and cos of the scan's angles: 15, 30 ... 165 degrees from straight down.
struct ScanAngle {
    double cos, sin;
};
constexpr double kSqrt2 = 1.4142135623730951, kSqrt3 = 1.7320508075688772, kSqrt6 = 2.449489742783178;
constexpr double kCos15 = (kSqrt6 + kSqrt2) / 4, kSin15 = (kSqrt6 - kSqrt2) / 4;
constexpr std::array<ScanAngle, 11> kScan = {{{kCos15, kSin15},
                                              {kSqrt3 / 2, 0.5},
                                              {kSqrt2 / 2, kSqrt2 / 2},
                                              {0.5, kSqrt3 / 2},
                                              {kSin15, kCos15},
                                              {0, 1},
                                              {-kSin15, kCos15},
                                              {-0.5, kSqrt3 / 2},
                                              {-kSqrt2 / 2, kSqrt2 / 2},
                                              {-kSqrt3 / 2, 0.5},
                                              {-kCos15, kSin15}}};

class Search {
public:
    Search(const SurfaceMesh& mesh, const ReadyParts& parts, const FaceRecord* faces,
           const Stance& stance) noexcept
        : mesh_(mesh), parts_(parts), faces_(faces), stance_(stance), up_(stance.up), down_(ray(-up_)) {}

    /// Where the walk found nothing.
    Underfoot run() noexcept {
        if (stance_.last < mesh_.triangles.size()) {
            if (search_rings(stance_.last)) return {hit_, FoundBy::rings};
            if (scan([&](const SurfaceRay& ray) { return nearest_around(ray, 0); }))
                return {hit_, FoundBy::scan};
        }
        return {search_all(), FoundBy::tree};
    }

private:
    SurfaceRay ray(const Vec3& direction) const noexcept {
        return {stance_.position, direction, stance_.reach};
    }

    /// Gathers the faces around `last` ring by ring, and tries the ray on each ring as it comes.
    bool search_rings(std::uint32_t last) noexcept {
        around_[0] = last;
        count_ = 1;
        std::size_t first = 0;
        for (int ring = 0; ring < kRings; ++ring) {
            const std::size_t end = count_;
            for (std::size_t i = first; i < end; ++i)
                for (const std::uint32_t vertex : mesh_.triangles[around_[i]]) add_ring(vertex);
            if (nearest_around(down_, end)) return true;
            first = end;
        }
        return false;
    }

    void add_ring(std::uint32_t vertex) noexcept {
        for (const std::uint32_t face : mesh::ring_at(mesh_, vertex)) {
            if (count_ == kMostAround) return;
            const auto end = around_.begin() + static_cast<std::ptrdiff_t>(count_);
            if (std::find(around_.begin(), end, face) == end) around_[count_++] = face;
        }
    }

    bool nearest_around(const SurfaceRay& ray, std::size_t first) noexcept {
        const WatertightRay<> tight(ray);
        NearestCrossing nearest(ray.reach);
        for (std::size_t i = first; i < count_; ++i) nearest.try_face(tight, faces_[around_[i]], around_[i]);
        return keep_nearer(nearest.hit());
    }

    bool keep_nearer(const SurfaceHit& hit) noexcept {
        if (hit.answer != Answer::found) return false;
        if (hit_.answer != Answer::found || hit.distance < hit_.distance) hit_ = hit;
        return true;
    }

    /// Of the first angle at which a ray meets something, the nearest crossing: behind, ahead, or to the sides.
    template <class Cast>
    bool scan(Cast&& cast) noexcept {
        const Vec3 flat = stance_.forward - dot(stance_.forward, up_) * up_;
        if (flat == Vec3{}) return false;
        const Vec3 ahead = unit(flat);
        const Vec3 left = cross(up_, ahead);
        for (const ScanAngle& angle : kScan) {
            bool found = false;
            for (const Vec3& aside : {-ahead, ahead, left, -left})
                found = cast(ray(angle.sin * aside - angle.cos * up_)) || found;
            if (found) return true;
        }
        return false;
    }

    SurfaceHit search_all() noexcept {
        const WideTree* tree = parts_.tree();
        if (tree == nullptr) return kFailedHit;
        const auto cast = [&](const SurfaceRay& ray) {
            return keep_nearer(first_hit(*tree, triangles_of(mesh_), ray));
        };
        if (cast(down_) || scan(cast)) return hit_;
        return closest_point(*tree, triangles_of(mesh_), stance_.position, stance_.reach);
    }

    const SurfaceMesh& mesh_;
    const ReadyParts& parts_;
    const FaceRecord* faces_;
    const Stance& stance_;
    Vec3 up_;
    SurfaceRay down_;
    SurfaceHit hit_;
    std::array<std::uint32_t, kMostAround> around_;
    std::size_t count_ = 0;
};

/// What the walk did not find.
[[gnu::noinline]] Underfoot search(const SurfaceMesh& mesh, const ReadyParts& parts, const FaceRecord* faces,
                                   const Stance& stance) noexcept {
    if (!is_sound(stance)) return {kRefusedHit};
    return Search(mesh, parts, faces, stance).run();
}

/// The edge that a line passes outside of by most; without branches, which nobody could foresee.
ORBWEAVER_INLINE std::size_t worst_edge(const EdgeFunctions& e) noexcept {
    const std::size_t edge = e.edges[0] < e.edges[2] ? 1 : 0;
    const std::size_t is_last = e.edges[1] < std::min(e.edges[0], e.edges[2]) ? 1 : 0;
    return edge + (2 - edge) * is_last;
}

/// Calls for the neighbours of a face that was just come to: most likely one of them is asked for soon.
ORBWEAVER_INLINE void fetch_around(const FaceRecord* faces, std::uint32_t face) noexcept {
    for (const FaceRecord::Row& row : faces[face].rows) {
        const FaceRecord* next =
            faces + (mesh::is_neighbour(row.across) ? mesh::across_triangle(row.across) : face);
        __builtin_prefetch(&next->rows[0]);
        __builtin_prefetch(&next->rows[2]);
    }
}

/// The last face and those beyond the edges that the ray passes outside of by most. A face of which the ray
/// would meet the other side lies under a fold: there the walk ends.
template <class Wide>
ORBWEAVER_INLINE Underfoot walk(const SurfaceMesh& mesh, const ReadyParts& parts, const Stance& stance,
                                const FaceRecord* faces, std::size_t axis) noexcept {
    const WatertightRay<Wide> line(stance.position, stance.up, axis);
    // NaN where forward is not finite; all else that makes a stance unsound fails the comparisons below.
    const double unsound = 0 * (stance.forward.x + stance.forward.y + stance.forward.z);
    // Whether the edge functions are below 0 inside of a face that turns the body's side to it.
    bool negative = (stance.side > 0) == line.points_along();
    std::uint32_t face = stance.last;
    for (int i = 0; i < kMostSteps; ++i) {
        EdgeFunctions e = line.edges(faces[face]);
        if (!e.have_sign<Wide>(negative)) {
            e.edges *= negative ? -1 : 1;
            if (!(e.least() >= 0)) {
                const std::uint32_t code = faces[face].rows[worst_edge(e)].across;
                if (!(e.total() > 0) || !mesh::is_neighbour(code)) break;
                face = mesh::across_triangle(code);
                negative ^= mesh::is_flipped(code);
                continue;
            }
        }
        const auto [scale, above] = line.crossing(e);
        if (!(unsound - above >= 0 && -above <= stance.reach)) break;
        if (i > 0) fetch_around(faces, face);
        return {{Answer::found, {face, weights_of(e.edges, scale)}, -above},
                i == 0 ? FoundBy::current : FoundBy::walk};
    }
    return search(mesh, parts, faces, stance);
}

template <class Wide>
ORBWEAVER_INLINE Underfoot ask(const SurfaceMesh& mesh, const ReadyParts& parts, const FaceRecord* faces,
                               const Stance& stance) noexcept {
    if (stance.last >= mesh.triangles.size() || (stance.side != 1 && stance.side != -1)) [[unlikely]]
        return search(mesh, parts, faces, stance);
    // Each axis has code of its own: a body keeps to one for a while, and foresight costs less than indices.
    switch (axis_of(stance.up)) {
        case 0:
            return walk<Wide>(mesh, parts, stance, faces, 0);
        case 1:
            return walk<Wide>(mesh, parts, stance, faces, 1);
        default:
            return walk<Wide>(mesh, parts, stance, faces, 2);
    }
}

[[gnu::noinline]] Underfoot ask_plain(const SurfaceMesh& mesh, const ReadyParts& parts, const FaceRecord* faces,
                                      const Stance& stance) noexcept {
    return ask<FourWide>(mesh, parts, faces, stance);
}
[[gnu::noinline]] ORBWEAVER_AVX2 Underfoot ask_avx2(const SurfaceMesh& mesh, const ReadyParts& parts,
                                                    const FaceRecord* faces, const Stance& stance) noexcept {
    return ask<EightWide>(mesh, parts, faces, stance);
}

const bool kWideVectors = has_avx2();

}  // namespace

Underfoot underfoot(const SurfaceMesh& mesh, const ReadyParts& parts, const Stance& stance) noexcept {
    const FaceRecord* faces = parts.faces();
    if (faces == nullptr) [[unlikely]]
        return {is_sound(stance) ? kFailedHit : kRefusedHit};
    return kWideVectors ? ask_avx2(mesh, parts, faces, stance) : ask_plain(mesh, parts, faces, stance);
}

}  // namespace orbweaver::surface
