#include "mesh_ways.hpp"

#include <array>

#include "every_triangle.hpp"
#include "watertight.hpp"

namespace orbweaver::surface {

namespace {

enum Number : std::size_t { kWalker, kWideTree, kEveryTriangle, kClosestPoint };

constexpr std::array<SurfaceWays::Way, 4> kWays = {
    {{"walker", "across edges from the last polygon, then rings, scan and tree", SurfaceWays::Finds::underfoot},
     {"wide_tree", "a ray through the wide tree", SurfaceWays::Finds::crossing},
     {"every_triangle", "a ray at each triangle in turn", SurfaceWays::Finds::crossing},
     {"closest_point", "the nearest point, by the wide tree", SurfaceWays::Finds::nearest}}};

}  // namespace

std::span<const SurfaceWays::Way> MeshWays::ways() const noexcept { return kWays; }

void MeshWays::answer(std::size_t way, std::span<const Stance> questions,
                      std::span<SurfaceHit> hits) const noexcept {
    const auto each = [&](auto&& ask) {
        for (std::size_t i = 0; i < questions.size(); ++i) hits[i] = ask(questions[i]);
    };
    const auto ray = [](const Stance& q) { return SurfaceRay{q.position, -q.up, q.reach}; };
    const TriangleSet set{surface_.vertices(), surface_.faces()};
    switch (way) {
        case kWalker:
            return each([&](const Stance& q) { return surface_.underfoot(q).hit; });
        case kWideTree:
            return each([&](const Stance& q) { return surface_.first_hit(ray(q)); });
        case kEveryTriangle:
            return each([&](const Stance& q) {
                return is_sound(ray(q)) ? first_hit_of_all(set, ray(q)) : kRefusedHit;
            });
        case kClosestPoint:
            return each([&](const Stance& q) { return surface_.closest_point(q.position, q.reach); });
        default:
            return each([](const Stance&) { return kRefusedHit; });
    }
}

}  // namespace orbweaver::surface
