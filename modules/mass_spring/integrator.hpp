#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// Runs a method over a spring system whose state is kept as a vector per particle.
class Integrator {
public:
    Integrator(SpringSystem& system, const MethodInfo& method);

    /// `count` steps of `h` seconds from x (m), v (m/s), in place.
    void advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count);
    std::size_t memory_bytes() const noexcept;

private:
    SpringSystem* system_;
    std::unique_ptr<Method> method_;
    std::vector<double> x_, v_;  ///< packed
};

}  // namespace orbweaver::mass_spring
