#include "output/telemetry.hpp"

#include <fmt/format.h>

namespace orbweaver {

Telemetry::Telemetry(const Session& session, const std::string& path) : session_(session), file_(path) {
    std::string header = "frame,time_s";
    for (const auto& instance : session.instances())
        for (const TelemetryColumn& column : instance->telemetry_columns()) {
            header += fmt::format(",{}.{}", instance->instance_name(), column.name);
            values_.push_back(column.value);
        }
    file_.write(header + ",state_hash\n");
}

void Telemetry::record() {
    std::string row = fmt::format("{},{}", session_.frame(), session_.time());
    for (const auto& value : values_) row += fmt::format(",{}", value());
    file_.write(row + fmt::format(",{:016x}\n", session_.state_hash()));
}

}  // namespace orbweaver
