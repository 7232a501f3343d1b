#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "method.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// What steps of the method's own choice came to.
struct ControlledRun {
    bool finished = false;
    bool stopped = false;    ///< since a stop was asked
    std::int64_t steps = 0;  ///< tried, parts of those that were divided too
    double next = 0;         ///< s, the step to go on with
    double error = 0;        ///< m, of the steps taken, added up
};

/// Runs a method over a spring system whose state is kept as a vector per particle.
class Integrator {
public:
    Integrator(SpringSystem& system, const MethodInfo& method);

    /// `count` steps of `h` seconds from x (m), v (m/s), in place. Arms of the system that are put on creep
    /// half a step before the method's first and after its last, and a whole one between (Strang 1968): to
    /// second order.
    void advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count);
    /// The same while `budget` allows. False where it did not; then x and v mean nothing.
    bool advance(std::span<Vec3> x, std::span<Vec3> v, double h, std::int64_t count, StepBudget& budget);
    /// Over `span` seconds in steps of the method's own choice, the first of at most `first` seconds, each with
    /// an error of at most `tolerance` m. Not finished when that takes more than `budget`, or would at ten
    /// times the pace, or takes steps that time no longer tells from none; then x and v are where it got to. Of
    /// methods with an embedded order, whose errors do not count what arms err: of systems without any put on.
    ControlledRun advance_within(std::span<Vec3> x, std::span<Vec3> v, double span, double tolerance,
                                 double first, StepBudget budget);
    /// Of convergence of advance().
    int order() const noexcept;
    std::size_t memory_bytes() const noexcept;

private:
    void begin(std::span<const Vec3> x, std::span<const Vec3> v, StepBudget& budget);
    void end(std::span<Vec3> x, std::span<Vec3> v);

    SpringSystem* system_;
    const MethodInfo* info_;
    std::unique_ptr<Method> method_;
    std::vector<double> x_, v_;              ///< packed
    std::vector<double> start_x_, start_v_;  ///< of a step that may be refused; empty until one is
};

}  // namespace orbweaver::mass_spring
