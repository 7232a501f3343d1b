#pragma once

#include <span>

namespace orbweaver::mass_spring {

/// What acts on a system between the steps of its method rather than within them: muscles, which give springs
/// other rest lengths, and contact, which turns velocities and presses. Vectors are packed (see Packing). It
/// knows when a step is taken from the frame that its owner is in and the steps since rewind(), and it
/// remembers nothing else, so that a frame can be run again.
class StepHooks {
public:
    /// The next step is the first of the frame.
    virtual void rewind() noexcept = 0;
    virtual void before_step(std::span<const double> x, std::span<const double> v, double h) noexcept = 0;
    virtual void after_step(std::span<double> x, std::span<double> v, double h) noexcept = 0;

    /// J since rewind(): done on the system, less what was taken from it, each as it changes the energy at
    /// once; and how much of both together.
    virtual double work() const noexcept = 0;
    virtual double turnover() const noexcept = 0;
    /// J since rewind(), that went by damping and drag, and by what work() has not because a method's lag puts
    /// it on the other side of a step.
    virtual double other_loss() const noexcept = 0;
    /// The frame stays as it was run since rewind().
    virtual void keep() noexcept = 0;

protected:
    ~StepHooks() = default;
};

}  // namespace orbweaver::mass_spring
