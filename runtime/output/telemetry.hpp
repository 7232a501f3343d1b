#pragma once

#include <functional>
#include <string>
#include <vector>

#include "output/atomic_file.hpp"
#include "run/session.hpp"

namespace orbweaver {

/// A CSV with a row a frame: frame, time, every telemetry column of every module, and the state's hash.
class Telemetry {
public:
    Telemetry(const Session& session, const std::string& path);
    void record();
    void commit() { file_.commit(); }

private:
    const Session& session_;
    AtomicFile file_;
    std::vector<std::function<double()>> values_;
};

}  // namespace orbweaver
