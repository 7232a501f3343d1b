#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "orbweaver/report.hpp"
#include "run/session.hpp"

namespace orbweaver {

/// Everything that a run says of itself when it ends, however it ends.
struct RunReport {
    struct ModuleEntry {
        std::string name;
        std::string module;
        double setup_s = 0;  ///< before time starts
        double wall_s = 0;   ///< in its frames
        std::size_t memory_bytes = 0;
        ModuleReport report;
    };

    std::string scene;
    std::uint64_t seed = 0;
    int threads = 1;
    double step_s = 0;
    std::uint64_t frames = 0;
    double simulated_s = 0;
    double wall_s = 0;
    std::string outcome;  ///< "done", "stopped", "refused", "invalid", "diverged", "limit", "failed"
    std::string message;  ///< the sentence behind an outcome other than done
    std::uint64_t state_hash = 0;
    std::vector<std::string> loaded_libraries;
    std::vector<std::pair<std::string, std::string>> left_out;  ///< module, reason
    std::vector<ModuleEntry> modules;

    double real_time_factor() const noexcept { return wall_s > 0 ? simulated_s / wall_s : 0; }
};

std::string report_json(const RunReport& report);
/// The closing lines: cost and error of each module side by side.
std::string report_text(const RunReport& report);

}  // namespace orbweaver
