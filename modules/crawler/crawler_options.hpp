#pragma once

#include <optional>
#include <string>
#include <vector>

#include "friction.hpp"
#include "gait.hpp"
#include "ground.hpp"
#include "lattice.hpp"
#include "mass_spring/linear_solver.hpp"
#include "mass_spring/simulation_settings.hpp"
#include "orbweaver/contracts/surface.hpp"
#include "orbweaver/module.hpp"
#include "steering.hpp"

namespace orbweaver::crawler {

/// What a [crawler] table asks for.
struct Crawler {
    std::uint32_t count = 1;
    Build build;
    const Gait* gait = nullptr;
    WaveForm form = WaveForm::sine;
    double waves = 1;   ///< in a length
    double period = 1;  ///< s
    Effort effort;      ///< its turn is the most
    Friction friction;
    double drag = 0;  ///< N s/m
    std::optional<Vec3> seek;
    std::optional<Path> path;
    std::vector<TimedCommand> script;
    mass_spring::SimulationSettings settings;
    mass_spring::LinearSolverKind linear_solver = mass_spring::LinearSolverKind::automatic;
};

/// `gravity`: m/s^2. What does not go together is reported where the scene says it.
Crawler read_crawler(const Options& options, const Vec3& gravity, Diagnostics& faults);

/// What there is to crawl on: a surface, a floor or a cliff.
Ground read_ground(const Options& options, const Crawler& crawler, const Surface* surface, Workers* workers,
                   Diagnostics& faults);

/// m, of all points, lying along the ground. Where a surface ends, they go straight on.
std::vector<Vec3> read_places(const Options& options, const Crawler& crawler, const Surface* surface,
                              Diagnostics& faults);

}  // namespace orbweaver::crawler
