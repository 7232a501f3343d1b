#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "command.hpp"
#include "orbweaver/contracts/creatures.hpp"
#include "orbweaver/random.hpp"
#include "steering.hpp"
#include "wall_following.hpp"
#include "way_field.hpp"

namespace orbweaver::spider {

/// What creatures of a kind want, and how much each of it counts; at a weight of 0 not at all. Constant over a
/// run.
struct Behaviors {
    struct Goal {
        WayField ways;  ///< to a point on the surface
        double weight = 0;
    };
    double wander = 1;
    Goal seek, flee, arrive;
    double flee_within =
        std::numeric_limits<double>::infinity();  ///< m of the way there; beyond: nothing to fear
    double slowing = 0;                           ///< m, see arrive()
    double pursue = 0, evade = 0;
    double evade_within = std::numeric_limits<double>::infinity();  ///< m
    double follow_path = 0;
    std::vector<Vec3> path;  ///< m
    bool loop = false;       ///< from the path's last point to its first
    double path_ahead = 0;   ///< m, see follow_path()
    double avoid_obstacles = 0;
    std::vector<Obstacle> obstacles;
    double keep_apart = 3;
    double apart = 0;  ///< m, within which it keeps away from others
    double follow_wall = 0;
    WallSettings walls;
};

/// Of ways and path.
std::size_t memory_bytes(const Behaviors& behaviors) noexcept;

/// What one creature lives among in a frame.
struct Company {
    const RandomStream& random;  ///< its own
    std::span<const Vec3> near;  ///< m, where others are
    std::optional<Agent> quarry = std::nullopt, hunter = std::nullopt;
    std::optional<Command> command = std::nullopt;  ///< by hand: overrides what it wants
    bool orients = true;                            ///< looks in this frame for the up that it wants
};

/// The wish of all behaviors together (m/s) of an agent at `at`; of those that have a state it is given, as
/// `wandering` and `along_wall`.
Vec3 combined(const Behaviors& behaviors, const Agent& agent, const SurfacePoint& at, const Company& company,
              const Vec3& wandering, const Vec3& along_wall) noexcept;

/// Whether its hunter is near enough to run from.
bool is_hunted(const Behaviors& behaviors, const Agent& agent, const Company& company) noexcept;

/// The one of a group that is nearest to `position` (m), but for number `self`; nothing where there is no
/// other.
std::optional<Agent> nearest_of(const Creatures& group, const Vec3& position, std::size_t self) noexcept;

}  // namespace orbweaver::spider
