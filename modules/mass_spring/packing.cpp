#include "packing.hpp"

namespace orbweaver::mass_spring {

void Packing::pack(std::span<const Vec3> vectors, std::span<double> packed) const noexcept {
    const std::size_t y = plane();
    const std::size_t z = 2 * y;
    for (std::size_t i = 0; i < particles_; ++i) {
        const std::size_t at = place(i);
        packed[at] = vectors[i].x;
        packed[y + at] = vectors[i].y;
        packed[z + at] = vectors[i].z;
    }
}

void Packing::unpack(std::span<const double> packed, std::span<Vec3> vectors) const noexcept {
    const std::size_t y = plane();
    const std::size_t z = 2 * y;
    for (std::size_t i = 0; i < particles_; ++i) {
        const std::size_t at = place(i);
        vectors[i] = {packed[at], packed[y + at], packed[z + at]};
    }
}

}  // namespace orbweaver::mass_spring
