#pragma once

#include <string>

#include "run/session.hpp"

namespace orbweaver {

/// Everything that changes over time, with the frame it belongs to, as bytes: magic, version, endianness,
/// checksum, step and a hash of the options, then every state array by name.
std::string save_snapshot(const Session& session);
/// Takes a snapshot up into a session of the same scene. Throws Fault(invalid), the session untouched,
/// when it is damaged, foreign, of other arrays, or of frames of another length. False when seed or options
/// are not those it was saved with.
bool restore_snapshot(Session& session, std::string_view bytes, const std::string& name);

/// Warns when seed or options are others.
void read_snapshot_file(Session& session, const std::string& path);

}  // namespace orbweaver
