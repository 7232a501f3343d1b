#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "orbweaver/random.hpp"
#include "orbweaver/vec3.hpp"
#include "plane.hpp"

namespace orbweaver::web {

/// What a piece of thread is to the web.
enum class Kind : std::uint8_t { anchor, frame, radius, hub, spiral, strand };
inline constexpr std::array<std::string_view, 6> kKindNames = {"anchor", "frame",  "radius",
                                                               "hub",    "spiral", "strand"};

using Index = std::uint32_t;

/// A straight piece of thread between two particles.
struct Piece {
    Index a = 0;
    Index b = 0;
    Kind kind = Kind::strand;
    double width = 1;  ///< times as much silk as others of its kind
};

/// Where everything is laid, before anything pulls: plain data that each stage of the construction adds to.
struct Layout {
    std::vector<Vec3> positions;      ///< m, one per particle
    std::vector<std::uint8_t> fixed;  ///< 1: the particle is an anchor
    std::vector<Piece> pieces;
    std::vector<Index> frame;                ///< inner frame masses in order around, counter-clockwise
    std::vector<std::size_t> corners;        ///< positions in `frame` of the inner frame points
    std::vector<std::vector<Index>> spokes;  ///< each from its frame mass to its hub mass, both included
    std::vector<Index> hub;                  ///< masses of the hub's ring, in order around
    Vec3 center;                             ///< m, middle of the hub (of a strand: its middle)
    Plane plane;

    bool is_orb() const noexcept { return !spokes.empty(); }
};

inline constexpr std::size_t kMostParticles = 500'000;

/// Throws Fault(limit) beyond kMostParticles.
Index add_particle(Layout& layout, const Vec3& position, bool fixed);

/// Draws the seeded irregularity: each draw is one further number of a stream.
class Jitter {
public:
    Jitter(const RandomStream& stream, double amount) noexcept : stream_(stream), amount_(amount) {}
    /// Uniform in [-amount/2, amount/2).
    double draw() noexcept { return amount_ == 0 ? 0 : amount_ * (stream_.uniform(next_++) - 0.5); }

private:
    RandomStream stream_;
    double amount_;
    std::uint64_t next_ = 0;
};

/// Lays a strand from one particle to another: masses as near to `placement` (m) apart as divides the
/// distance evenly, at least `least` pieces, each inner mass displaced along the strand by the jitter times the
/// spacing. Returns its particles, both ends included.
std::vector<Index> lay_strand(Layout& layout, Index from, Index to, Kind kind, double placement,
                              std::size_t least, Jitter& jitter);

}  // namespace orbweaver::web
