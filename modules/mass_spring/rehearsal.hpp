#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "integrator.hpp"
#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// External forces on the particles, N, at a time of a run, s. What it returns holds until the next call.
using LoadAt = std::function<std::span<const Vec3>(double time)>;

/// A run as far as it is known before it begins: from rest at x, `frames` frames of `frame_step` seconds under
/// `load` (empty: the surroundings' own), constant over a frame.
struct RunAhead {
    Surroundings surroundings;
    std::span<const Vec3> x;  ///< m
    LoadAt load;
    double frame_step = 0;  ///< s
    double frames = 1;
};

/// A method with the number of its equal steps in a frame.
struct Pace {
    const MethodInfo* method = nullptr;
    std::int64_t substeps = 1;
};

/// What a rehearsal may take.
struct WorkLimit {
    double seconds = 0;             ///< of work
    std::int64_t max_substeps = 0;  ///< a frame, parts of divided steps counted
};

/// What a method made of the frames that are rehearsed.
struct Performance {
    std::vector<Vec3> x;  ///< m, of all particles at the end of each frame
    double cost = 0;      ///< s of work a frame
    int order = 0;        ///< of convergence
};

/// Frames of a run ahead, to try methods on: its first ones, and those around the moment at which its load and
/// the change of it are strongest, from the state that a scout is in by then.
class Rehearsal {
public:
    Rehearsal(SpringSystem& system, RunAhead run);
    ~Rehearsal();  ///< the system's surroundings are as before
    Rehearsal(const Rehearsal&) = delete;
    Rehearsal& operator=(const Rehearsal&) = delete;

    /// s of work of a frame, the one of the strongest load, from rest; nothing where it takes too many
    /// substeps.
    std::optional<double> cost_of_a_frame(const Pace& pace, const WorkLimit& limit);

    /// The run's first `count` frames are rehearsed.
    void take_first(std::size_t count);
    /// About `count` frames are, of the first `horizon`, which the scout runs as far as the limit allows.
    /// Returns how many times as far apart it and a twin are after each frame that begin 0.1 nm apart.
    std::vector<double> take_strongest(std::size_t count, std::size_t horizon, const Pace& scout,
                                       const WorkLimit& limit);
    std::size_t frames() const noexcept;           ///< rehearsed in all
    std::size_t longest_stretch() const noexcept;  ///< frames that follow each other
    /// How many times as strong as what is rehearsed the load becomes in the run.
    double strength_ahead() const noexcept { return strength_ahead_; }

    /// Nothing where that takes more than the limit, whose seconds are looked at before each frame, or would
    /// have a Simulation redo a frame in more steps than the limit allows.
    std::optional<Performance> perform(const Pace& pace, const WorkLimit& limit);

private:
    /// Frames [first, first + count), and the state that they begin in.
    struct Stretch {
        std::size_t first = 0;
        std::size_t count = 0;
        std::vector<Vec3> x, v;
        std::vector<double> creep;  ///< empty: arms are put on at x
    };
    struct Strongest {
        double frame = 0;
        double strength = 0;  ///< N
    };
    Strongest strongest_within(double frames);
    void blow(double frame);
    Stretch from_start(std::size_t count) const;
    /// A frame. False where it takes too many steps, or gains energy and cannot be redone in twice as many.
    bool advance(Integrator& integrator, const Pace& pace, std::int64_t max_substeps, std::vector<Vec3>& x,
                 std::vector<Vec3>& v);
    /// Notes the state before frame `into.first`, where that is not null.
    bool play(const Stretch& stretch, const Pace& pace, const WorkLimit& limit, Performance& performance,
              Stretch* into = nullptr);

    SpringSystem& system_;
    RunAhead run_;
    Strongest strongest_;  ///< of the run
    double strength_ahead_ = 1;
    std::vector<Stretch> stretches_;
};

}  // namespace orbweaver::mass_spring
