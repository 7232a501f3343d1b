#include "integrator.hpp"

namespace orbweaver::mass_spring {

Integrator::Integrator(SpringSystem& system, const MethodInfo& method)
    : system_(&system), method_(method.make(system.length())), x_(system.length()), v_(system.length()) {}

void Integrator::advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count) {
    const Packing& packing = system_->packing();
    packing.pack(x, x_);
    packing.pack(v, v_);
    method_->begin();
    for (std::int64_t i = 0; i < count; ++i) method_->step(*system_, x_, v_, h);
    packing.unpack(x_, x);
    packing.unpack(v_, v);
}

std::size_t Integrator::memory_bytes() const noexcept {
    return method_->memory_bytes() + (x_.capacity() + v_.capacity()) * sizeof(double);
}

}  // namespace orbweaver::mass_spring
