#pragma once

#include <array>
#include <span>
#include <vector>

#include "friction.hpp"
#include "gait.hpp"
#include "ground.hpp"
#include "lattice.hpp"
#include "mass_spring/method.hpp"
#include "mass_spring/spring_system.hpp"
#include "mass_spring/step_hooks.hpp"
#include "muscles.hpp"
#include "orbweaver/contracts/workers.hpp"

namespace orbweaver::crawler {

/// What muscles are told for one frame, at its begin and at its end; in between it changes evenly.
struct Drive {
    std::array<double, 2> cycles{};  ///< of the gait, since the start
    std::array<Effort, 2> effort{};
    /// How far springs are of the lengths that muscles ask for, and no more of those that they had as the body
    /// was laid down, if it was.
    std::array<double, 2> ease{1, 1};
};

/// J, over a frame or a run of all bodies, and what goes with them.
struct Books {
    double muscles = 0;   ///< that muscles did
    double damping = 0;   ///< that springs' damping and drag took
    double friction = 0;  ///< that sliding took
    double impact = 0;    ///< that the ground took of motion into it, less what it gave by lifting points
    double lift = 0;      ///< that it gave by lifting them
    double slip = 0;      ///< m, that points slid on the ground, all together
    double contact = 0;   ///< s, that points were on the ground, all together
    double lagging = 0;  ///< J, of the work in friction and impact, what a method's lag put there (see Landing)

    Books& operator+=(const Books& o) noexcept;
};

/// What a step leaves to the next one, one of each for a point: it goes on from frame to frame, as the owner's
/// state.
struct StepTrace {
    std::span<Vec3> reaction;  ///< N, by which the ground presses
    std::span<Vec3> turned;    ///< m/s, by which it turned points when the step ended, see Landing
    std::span<Vec3> x, v;      ///< m, m/s, where the step began
};

/// Bodies that crawl: between the steps of a method, muscles give springs their lengths and the ground meets
/// points. Lengths are those of the waves a hundred times a cycle, and at the begin and the end of each frame;
/// in between they change evenly. A point that gets below the ground is put onto it, loses its velocity into
/// it, and slides as friction has it by the impulse that this took (Miller 1988; Moreau 1988). While a step is
/// taken, the ground presses as that impulse did over the step before, so that what lies on it lies still and
/// does not fall and jump: the impulse after the step is what that fell short of.
class Crawl final : public mass_spring::StepHooks {
public:
    /// `system` is of the lattice's network as `build` makes it, has these hooks from then on, and outlives
    /// them and `method`, which integrates it.
    Crawl(mass_spring::SpringSystem& system, const Lattice& lattice, const Build& build, const Waves& waves,
          const Friction& friction, Ground ground, const StepTrace& trace,
          const mass_spring::MethodInfo& method, Workers* workers);

    /// Puts points of x (m) that are below the ground onto it.
    void lift_out(std::span<Vec3> x);
    /// Bodies were laid down at x (m), where springs then hold nothing if drives say so.
    void lay_down(std::span<const Vec3> x);
    /// A frame of so many seconds begins at x (m), v (m/s); one drive for each body.
    void begin_frame(std::span<const Drive> drives, std::span<const Vec3> x, std::span<const Vec3> v,
                     double seconds);
    /// Over all frames that were kept.
    const Books& books() const noexcept { return kept_; }
    /// As they were when a run was saved that this one goes on from.
    void set_books(const Books& books) noexcept { kept_ = books; }
    std::size_t memory_bytes() const noexcept;

    void rewind() noexcept override;
    void before_step(std::span<const double> x, std::span<const double> v, double h) noexcept override;
    void after_step(std::span<double> x, std::span<double> v, double h) noexcept override;
    double work() const noexcept override;
    double turnover() const noexcept override;
    double other_loss() const noexcept override;
    void keep() noexcept override;

private:
    /// Of one body: threads share the bodies.
    struct Body {
        Muscles muscles;
        std::vector<Flex> flexes;   ///< at the end of the stretch
        std::vector<double> rest;   ///< m, in the order of its springs
        std::vector<Vec3> middles;  ///< m, of rings
        /// Whether any of four points was on the ground after the last step, in the order that they are met in.
        std::vector<std::uint8_t> met;
        Books frame;
    };

    template <class F>
    void for_each_body(const F& f) noexcept;
    template <class F>
    void with_ground(const F& f) noexcept;
    SurfaceGround* surface_ground() noexcept { return std::get_if<SurfaceGround>(&ground_); }
    void find_lengths(std::uint32_t body, mass_spring::PathEnd end, double share) noexcept;
    void begin_stretch(std::size_t number) noexcept;
    void look_again(std::span<const double> x, std::span<const double> v) noexcept;
    std::array<std::span<double>, 4> packed_trace() noexcept;
    double holds(std::size_t ring, const Body& body) const noexcept;
    template <class AnyGround>
    void meet(const AnyGround& ground, std::uint32_t number, std::span<double> x, std::span<double> v,
              double h) noexcept;

    mass_spring::SpringSystem* system_;
    Lattice lattice_;
    Build build_;
    Waves waves_;
    Friction friction_;
    Ground ground_;
    Workers* workers_;
    const mass_spring::MethodInfo* method_;
    std::array<std::span<Vec3>, 4> trace_;          // state
    std::array<std::vector<Vec3>, 4> start_trace_;  // of the frame
    std::vector<double> start_x_;                   // m, packed, of the step
    std::vector<double> start_v_;                   // m/s, likewise
    std::vector<double> turned_;                    // m/s, likewise: see Landing
    std::vector<Vec3> look_x_, look_v_;             // m, m/s, scratch; empty: there is no surface
    std::vector<Drive> drives_;
    std::vector<double> laid_;   // m, springs' lengths as bodies were laid down; empty: as muscles ask for
    double seconds_ = 1;         // of the frame
    double elapsed_ = 0;         // s, of it
    std::size_t stretches_ = 1;  // of it, through each of which lengths change evenly
    std::size_t stretch_ = 0;    // the one that springs are in
    std::size_t looks_ = 1;      // at a surface in it, evenly apart
    std::size_t look_ = 0;       // which of them was the last one
    Books frame_, kept_;
    std::vector<Body> bodies_;
};

}  // namespace orbweaver::crawler
