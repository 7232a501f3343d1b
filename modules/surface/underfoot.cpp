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

/// The last face and those beyond the edges that the ray passes outside of. A face of which the ray would meet
/// the other side lies under a fold: there the walk ends.
bool walk(const SurfaceMesh& mesh, const Stance& stance, Underfoot& found) noexcept {
    const WatertightRay tight({stance.position, -stance.up, stance.reach});
    std::uint32_t face = stance.last;
    int side = stance.side;
    for (int i = 0; i < kMostSteps; ++i) {
        const auto& c = mesh.triangles[face];
        const Vec3& p = mesh.vertices[c[0]];
        if (side * dot(cross(mesh.vertices[c[1]] - p, mesh.vertices[c[2]] - p), stance.up) <= 0) return false;
        Crossing crossing;
        if (tight.meets(mesh.vertices, mesh.triangles[face], stance.reach, crossing) ==
            WatertightRay::Meets::crosses) {
            fill_in(found.hit, triangles_of(mesh), face, crossing);
            found.by = i == 0 ? FoundBy::current : FoundBy::walk;
            return true;
        }
        const int edge = tight.outside_of(mesh.vertices, mesh.triangles[face]);
        if (edge < 0) return false;
        const std::uint32_t code = mesh.across[face][static_cast<std::size_t>(edge)];
        if (!mesh::is_neighbour(code)) return false;
        face = mesh::across_triangle(code);
        if (mesh::is_flipped(code)) side = -side;
    }
    return false;
}

class Search {
public:
    Search(const SurfaceMesh& mesh, const ReadyTree& tree, const Stance& stance) noexcept
        : mesh_(mesh), tree_(tree), stance_(stance), up_(stance.up), down_(ray(-up_)) {}

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
        const WatertightRay tight(ray);
        NearestCrossing nearest(ray.reach);
        for (std::size_t i = first; i < count_; ++i)
            nearest.try_face(tight, mesh_.vertices, mesh_.triangles[around_[i]], around_[i]);
        return keep_nearer(nearest.hit(triangles_of(mesh_)));
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
        const WideTree* tree = tree_.get();
        if (tree == nullptr) return {Answer::failed, {}, 0, {}, {}};
        const auto cast = [&](const SurfaceRay& ray) {
            return keep_nearer(first_hit(*tree, triangles_of(mesh_), ray));
        };
        if (cast(down_) || scan(cast)) return hit_;
        return closest_point(*tree, triangles_of(mesh_), stance_.position, stance_.reach);
    }

    const SurfaceMesh& mesh_;
    const ReadyTree& tree_;
    const Stance& stance_;
    Vec3 up_;
    SurfaceRay down_;
    SurfaceHit hit_;
    std::array<std::uint32_t, kMostAround> around_;
    std::size_t count_ = 0;
};

}  // namespace

Underfoot underfoot(const SurfaceMesh& mesh, const ReadyTree& tree, const Stance& stance) noexcept {
    Underfoot found;
    if (!is_sound(stance))
        found.hit.answer = Answer::refused;
    else if (stance.last >= mesh.triangles.size() || !walk(mesh, stance, found))
        found = Search(mesh, tree, stance).run();
    return found;
}

}  // namespace orbweaver::surface
