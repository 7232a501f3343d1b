#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace orbweaver {

/// Why a run cannot go on. The value is the process's exit code.
enum class FaultKind : int {
    stopped = 0,   ///< nothing is wrong: a frame was given up since a stop was asked (see Host::stop_asked())
    internal = 1,  ///< anything else
    invalid = 3,   ///< scene or asset invalid
    diverged = 4,  ///< the numbers stopped meaning anything, or would have
    limit = 5,     ///< a limit was hit: memory, time, size
};

/// A full sentence: what, where, what was expected, what to do. Thrown inside the host or inside a
/// module; never across a module's boundary, where it becomes a FaultRecord.
class Fault : public std::runtime_error {
public:
    Fault(FaultKind kind, const std::string& sentence) : std::runtime_error(sentence), kind_(kind) {}
    FaultKind kind() const noexcept { return kind_; }

private:
    FaultKind kind_;
};

/// A Fault as it crosses a module's boundary.
struct FaultRecord {
    FaultKind kind = FaultKind::internal;
    std::string sentence;
};

}  // namespace orbweaver
