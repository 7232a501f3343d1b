#include "run/recorders.hpp"

namespace orbweaver {

Recorders::Recorders(const RunSettings& settings, const Session& session) {
    if (!settings.trajectory_directory.empty())
        trajectory = std::make_unique<Trajectory>(session, settings.trajectory_directory);
    if (!settings.telemetry_file.empty())
        telemetry = std::make_unique<Telemetry>(session, settings.telemetry_file);
    if (!settings.save_state_file.empty()) state = std::make_unique<AtomicFile>(settings.save_state_file);
}

void Recorders::record() const {
    if (trajectory) trajectory->record();
    if (telemetry) telemetry->record();
}

}  // namespace orbweaver
