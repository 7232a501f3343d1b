#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lattice.hpp"
#include "orbweaver/contracts/patches.hpp"

namespace orbweaver::crawler {

/// Control points of a body's skin: those of each ring, and a point beyond each end in which it closes.
PatchLayout skin_layout(const Lattice& lattice) noexcept;

/// The skin of all bodies of a kind: its map is drawn here, of scales, rings or hairs.
class Skin {
public:
    /// `kind`: "snake", "worm", "caterpillar"; others look like worms.
    Skin(std::string_view kind, const Lattice& lattice, const Build& build);

    PatchMap map() const noexcept { return {kColumns, rows_, texels_, relief_, gloss_}; }
    /// m, of the masses' positions.
    std::span<const Vec3> points(std::span<const Vec3> masses);
    std::size_t memory_bytes() const noexcept;

private:
    static constexpr std::uint32_t kColumns = 128;  ///< texels around

    void add_ring(const Vec3& middle, const Vec3* corners, double thickness, double out);
    void add_body(std::span<const Vec3> masses);

    Lattice lattice_;
    std::uint32_t rows_ = 0;
    double relief_ = 0;  ///< m
    double gloss_ = 0;
    std::vector<double> thickness_;  ///< of the skin at each ring, over that of the lattice
    std::vector<std::uint8_t> texels_;
    std::vector<Vec3> points_;
};

}  // namespace orbweaver::crawler
