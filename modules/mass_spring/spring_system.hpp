#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "implicit_tangent.hpp"
#include "network.hpp"
#include "orbweaver/contracts/workers.hpp"
#include "orbweaver/vec3.hpp"
#include "packing.hpp"
#include "spectral_bound.hpp"
#include "spring_force.hpp"
#include "spring_kernel.hpp"
#include "step_hooks.hpp"

namespace orbweaver::mass_spring {

/// Of stiffness: as it is, or with springs in compression clamped so that it is semi-definite.
enum class Tangent : std::uint8_t { exact, clamped };

/// All that a method of integration knows of what it integrates: x'' = a(x, v), in flat vectors whose
/// layout is the system's own business.
class DynamicSystem {
public:
    virtual std::size_t length() const noexcept = 0;  ///< of x, of v and of a
    virtual void accelerations(std::span<const double> x, std::span<const double> v,
                               std::span<double> a) noexcept = 0;
    /// The same, of the x and v that a step begins at: what was found of them before it need not be found anew.
    virtual void accelerations_at_start(std::span<const double> x, std::span<const double> v,
                                        std::span<double> a) noexcept {
        accelerations(x, v, a);
    }

    /// For methods of kicks and drifts, of systems that drag alone damps: v += kick a(x, 0), and then all goes
    /// on for `drift` seconds, which may be negative, as if nothing acted but drag (see drag_drift.hpp).
    virtual void kick_and_drift(std::span<double> x, std::span<double> v, double kick,
                                double drift) noexcept = 0;

    /// For stabilised methods: no eigenvalue of the Jacobian is larger, 1/s, however the system may stand.
    virtual double spectral_radius() = 0;

    /// For implicit methods: makes W = M + c C + k K ready to be solved, with mass matrix M and the tangents of
    /// damping C = -df/dv and stiffness K = -df/dx at x. False where W is not positive definite, which a
    /// clamped K sees to unless x is far off.
    virtual bool prepare(std::span<const double> x, double c, double k, Tangent tangent) = 0;
    /// u = W^-1 M r.
    virtual void solve(std::span<const double> r, std::span<double> u) = 0;
    /// r M u.
    virtual double inner_product(std::span<const double> r, std::span<const double> u) const noexcept = 0;

    /// For position-based methods, which meet the springs one by one. Accelerations by all else
    /// over h seconds, drag by the velocity at their end, so that it never turns a motion round.
    virtual void free_accelerations(std::span<const double> v, std::span<double> a,
                                    double h) const noexcept = 0;
    /// x, reached from `start` in h seconds, moves by what each spring in turn pulls over that time.
    virtual void project_springs(std::span<const double> start, std::span<double> x,
                                 double h) const noexcept = 0;
    /// Springs strained by more than `strain` are shortened to that, each in turn.
    virtual void limit_strain(std::span<double> x, double strain) const noexcept = 0;

protected:
    ~DynamicSystem() = default;
};

enum class PathEnd : std::uint8_t { begin, end };

/// What acts on the particles from outside the springs.
struct Surroundings {
    Vec3 gravity;                    ///< m/s^2
    double drag = 0;                 ///< k_d of f = -k_d v, N s/m, the same for every particle
    std::span<const Vec3> external;  ///< N per particle; empty: none
};

/// Mechanical energy in joules. Potential is of gravity, zero at the origin.
struct Energy {
    double kinetic = 0;
    double elastic = 0;
    double potential = 0;
    double total() const noexcept { return kinetic + elastic + potential; }
};

/// Springs, gravity, viscous drag and external forces over a Network:
/// m a = sum of spring forces + m g - k_d v + f_external.
/// The sum over a particle's springs runs in order of spring index whatever the number of workers and
/// the width of vectors, so the bits are the same.
class SpringSystem final : public DynamicSystem {
public:
    /// `network` must outlive the system and be sound (see validate()). Null workers: one thread.
    SpringSystem(const Network& network, Workers* workers);

    /// Arms (see MaterialLaw) bear nothing, as if there were none, until they are put on: from then on they
    /// bear nothing at x, and their dashpots creep. No effect where there are none.
    void put_on_arms(std::span<const Vec3> x);
    /// How many creeps there are: one a spring, 0 where none are put on.
    std::size_t creep_count() const noexcept;
    /// q of the dashpots (m), creep_count() of them in order of the springs.
    void get_creep(std::span<double> creep) const noexcept;
    void set_creep(std::span<const double> creep) noexcept;
    /// The dashpots creep for h seconds at packed x. With arms put on.
    void creep(std::span<const double> x, double h) noexcept;

    /// After springs of the network were added, removed, cut or given other constants: what is derived from
    /// them is made anew, and arms bear nothing. Particles stay as many as they were. A running Simulation is
    /// told instead of this.
    void network_changed();

    /// m, of a spring of a driven network: rest lengths go evenly from those of a begin to those of an end.
    void set_rest_path(std::size_t spring, PathEnd end, double length) noexcept {
        const std::size_t at = table_.place[spring];
        DrivenQuad& quad = driven_[at / Packing::kLanes];
        (end == PathEnd::begin ? quad.begin : quad.end)[at % Packing::kLanes] = length;
    }
    /// Springs have those of the path's begin, and no work is told. The step before began at packed x and v.
    void begin_rest_path(std::span<const double> x, std::span<const double> v) noexcept;
    /// Springs have those at `share` of the path from now on, a step beginning at packed x and v. Work is told
    /// of positions older than x by `lag` steps (see MethodInfo): it is there that a method keeps energy.
    /// Damping is that of the way since the step before began.
    DriveWork drive(std::span<const double> x, std::span<const double> v, double share, double lag) noexcept;
    double rest_length(std::size_t spring) const noexcept {
        if (!network_->driven) return network_->springs[spring].rest_length;
        const std::size_t at = table_.place[spring];
        return table_.quads[at / Packing::kLanes].rest_length[at % Packing::kLanes];
    }
    /// What acts between steps, and outlives the system; null: nothing.
    void set_hooks(StepHooks* hooks) noexcept { hooks_ = hooks; }
    StepHooks* hooks() const noexcept { return hooks_; }
    /// External forces (N, packed) of the steps to come, where hooks set them instead of the surroundings.
    std::span<double> hook_forces();
    /// The next step is the first of a frame, to which dashpots had crept so far.
    void begin_frame(std::span<const double> creep) noexcept;

    /// In force until the next call; the external forces are copied.
    void set_surroundings(const Surroundings& surroundings);
    /// Of implicit methods, from the next prepare() on, and of settle().
    void use_linear_solver(LinearSolverKind kind);
    LinearSolverKind linear_solver() const noexcept { return linear_solver_; }
    const Network& network() const noexcept;
    std::size_t size() const noexcept;  ///< particles
    std::size_t memory_bytes() const noexcept;

    /// What the calls of methods so far take on one core of a desktop of 2020, counted and not timed: the same
    /// wherever it runs. Figures of README, "Work".
    double work_seconds() const noexcept { return work_; }
    double evaluation_seconds() const noexcept;  ///< of accelerations(), and a method's sums with them

    /// The layout of the flat vectors.
    const Packing& packing() const noexcept;
    std::size_t length() const noexcept override;
    /// m/s^2; zero for fixed particles.
    void accelerations(std::span<const double> x, std::span<const double> v,
                       std::span<double> a) noexcept override;
    void accelerations_at_start(std::span<const double> x, std::span<const double> v,
                                std::span<double> a) noexcept override;
    void kick_and_drift(std::span<double> x, std::span<double> v, double kick, double drift) noexcept override;
    double spectral_radius() override { return spectral_bound().radius(); }
    bool prepare(std::span<const double> x, double c, double k, Tangent tangent) override;
    void solve(std::span<const double> r, std::span<double> u) override;
    double inner_product(std::span<const double> r, std::span<const double> u) const noexcept override;
    void free_accelerations(std::span<const double> v, std::span<double> a, double h) const noexcept override;
    void project_springs(std::span<const double> start, std::span<double> x, double h) const noexcept override;
    void limit_strain(std::span<double> x, double strain) const noexcept override;

    /// However the particles may stand; found when first asked for, and not by several threads at once.
    const SpectralBound& spectral_bound() const;
    Tension tension(std::size_t spring, double length) const noexcept;  ///< with its arm
    Vec3 external_force(std::size_t particle) const noexcept;           ///< N
    const Vec3& gravity() const noexcept { return gravity_; }           ///< m/s^2
    double drag() const noexcept { return drag_; }                      ///< N s/m
    /// Net force (N) on every particle, fixed ones too: at rest, minus what its anchor bears.
    void forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> f) const noexcept;
    Energy energy(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept;

    /// Other kernels than the best, to compare them; the bits are the same.
    void use_kernels(const SpringKernels& kernels) noexcept { kernels_ = &kernels; }

private:
    KernelInput kernel_input(const double* x, const double* v) const noexcept;
    std::vector<DrivenQuad> still_path() const;
    template <class Pass>
    void share_quads(Pass pass) noexcept;
    void find_pulls(const KernelInput& input) noexcept;
    /// After find_pulls(): `second_pass(begin, end)` over all blocks.
    template <class SecondPass>
    void use_pulls(SecondPass second_pass) noexcept;

    const Network* network_;
    Workers* workers_;  ///< null when there are too few springs to share
    SpringTable table_;
    const SpringKernels* kernels_;
    Vec3 gravity_;
    double drag_ = 0;
    std::vector<double> external_;    ///< packed; empty: none
    std::vector<double> pull_;        ///< N, three planes of a slot per spring, scratch
    std::vector<DrivenQuad> driven_;  ///< empty: not driven
    bool has_pulls_ = false;          ///< pull_ is that of where a step begins
    std::vector<DriveWork> drives_;   ///< of ranges of quads, scratch
    std::vector<double> creep_;       ///< m, as table_.place says; empty: arms bear nothing
    LinearSolverKind linear_solver_ = LinearSolverKind::automatic;
    std::unique_ptr<ImplicitTangent> implicit_;  ///< null until an implicit method asks
    mutable double work_ = 0;                    ///< s
    StepHooks* hooks_ = nullptr;
    mutable std::optional<SpectralBound> spectral_bound_;  ///< none until somebody asks
};

/// Tension (N, negative in compression) of one spring without its arm, its elastic part.
double tension(const Spring& spring, std::span<const Vec3> x) noexcept;

}  // namespace orbweaver::mass_spring
