#pragma once

#include <memory>

#include "output/atomic_file.hpp"
#include "output/telemetry.hpp"
#include "output/trajectory.hpp"
#include "run/run_scene.hpp"

namespace orbweaver {

/// The files that a run was asked to leave; null: not asked. All are opened before it starts, so that what
/// cannot be written is known then. Throws Fault.
struct Recorders {
    std::unique_ptr<Trajectory> trajectory;
    std::unique_ptr<Telemetry> telemetry;
    std::unique_ptr<AtomicFile> state;

    Recorders(const RunSettings& settings, const Session& session);
    /// The session's present state, where a row a frame is asked for.
    void record() const;
};

}  // namespace orbweaver
