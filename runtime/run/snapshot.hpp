#pragma once

#include <string>

#include "run/session.hpp"

namespace orbweaver {

/// Everything that changes over time, with the frame it belongs to, as bytes: magic, version, endianness,
/// checksum, then every state array by name.
std::string save_snapshot(const Session& session);
/// Takes a snapshot up into a session of the same scene. Throws Fault(invalid), the session untouched,
/// when it is damaged, foreign, or of other arrays.
void restore_snapshot(Session& session, std::string_view bytes, const std::string& name);

void read_snapshot_file(Session& session, const std::string& path);

}  // namespace orbweaver
