#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "leg.hpp"
#include "orbweaver/contracts/skins.hpp"
#include "orbweaver/random.hpp"

namespace orbweaver::spider {

/// Which bones a piece of skin goes with: `share` of it with `b`, the rest with `a`.
struct SkinBinding {
    std::size_t a = 0, b = 0;
    double share = 0;
};

/// What a piece of skin looks like: sRGB shade, and gloss.
struct SkinPaint {
    Vec3 color;
    double gloss = 0;
};

/// A ring of a tube, m: x of its axes points on along the tube, y and z span it.
struct SkinRing {
    Vec3 middle;
    Frame axes;
    double up = 0, down = 0, side = 0;  ///< half axes: towards y, against it, and towards both sides
    SkinBinding binding;
};

/// A tube from point to point.
struct SkinTube {
    Vec3 start;
    std::vector<SkinRing> rings;
    Vec3 end;
};

/// Thin spikes on the triangles [first, end), evenly over their area.
struct SkinFur {
    std::size_t first = 0, end = 0, count = 0;
    double length = 0, width = 0;  ///< m, on the mean
};

/// Makes skins: parts that are closed, each on its own.
class SkinBuilder {
public:
    /// With `sides` corners to a ring. `paint(ring, y, z)` says what each looks like, (y, z) being its
    /// direction within the ring, of length 1; an end looks as the ring next to it in its middle, at (0, 0).
    template <class Paint>
    void add_tube(const SkinTube& tube, std::size_t sides, const Paint& paint);

    /// On one bone.
    void add_ball(const Vec3& middle, double radius, std::size_t bone, const SkinPaint& paint);

    /// Makes the normals of all that is there: the mean of the triangles around, as their areas weigh.
    void smooth();

    /// Hairs lean along `leans` (of each bone, unit) and are lit as the skin below them: after smooth().
    void add_fur(const SkinFur& fur, std::span<const Vec3> leans, const RandomStream& random);

    std::vector<SkinVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

private:
    std::uint32_t add_vertex(const Vec3& position, const SkinBinding& binding, const SkinPaint& paint);
    void add_hair(const std::array<std::uint32_t, 3>& skin, const SkinFur& fur, const Vec3& lean,
                  const std::array<double, 5>& chance);
    /// Triangles of a tube whose first vertex is its start, whose last is its end.
    void join(std::uint32_t start, std::size_t rings, std::size_t sides);
    static Vec3 around(std::size_t side, std::size_t sides) noexcept;  ///< {0, y, z}
};

template <class Paint>
void SkinBuilder::add_tube(const SkinTube& tube, std::size_t sides, const Paint& paint) {
    const auto& rings = tube.rings;
    const std::uint32_t start = add_vertex(tube.start, rings.front().binding, paint(0, 0, 0));
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const SkinRing& ring = rings[r];
        for (std::size_t i = 0; i < sides; ++i) {
            const Vec3 way = around(i, sides);
            const Vec3 place = ring.middle + way.y * (way.y > 0 ? ring.up : ring.down) * ring.axes.y +
                               way.z * ring.side * ring.axes.z;
            add_vertex(place, ring.binding, paint(r, way.y, way.z));
        }
    }
    add_vertex(tube.end, rings.back().binding, paint(rings.size() - 1, 0, 0));
    join(start, rings.size(), sides);
}

}  // namespace orbweaver::spider
