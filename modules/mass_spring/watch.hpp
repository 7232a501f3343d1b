#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "integrator.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// Tells states that mean something from those that do not.
class Watch {
public:
    /// Reach: 1e6 times the extent of `x` (at least of 1 m) from its middle.
    explicit Watch(std::span<const Vec3> x);

    /// The first particle whose position or velocity is not finite, or that left; x.size() when all are sound.
    std::size_t first_bad(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept;
    bool within_reach(const Vec3& position) const noexcept;

private:
    Vec3 middle_;
    double reach_ = 0;
};

/// `count` steps of h seconds from x, v in place; false as soon as a value is found to mean nothing, or the
/// budget refuses a step.
bool advance_watched(Integrator& integrator, const Watch& watch, std::span<Vec3> x, std::span<Vec3> v, double h,
                     std::int64_t count, StepBudget& budget);

/// Which particle went bad first, and by which term of its equation.
struct Culprit {
    std::size_t particle = 0;
    const char* term = "";  ///< "external force", "spring force", "spring damping" or "drag"
};

/// Looks at the sound state x, v just before `first_bad`: the first particle whose net force is not finite
/// there and the term that makes it so; when all are finite, `first_bad` and its largest term.
Culprit find_culprit(const SpringSystem& system, std::span<const Vec3> x, std::span<const Vec3> v,
                     std::size_t first_bad);

}  // namespace orbweaver::mass_spring
