#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace orbweaver {

using MeasureValue = std::variant<std::int64_t, double, std::string>;

/// What a module says of itself at the end of a run; the host adds name, wall time and state size.
struct ModuleReport {
    struct Error {
        double value = 0;
        std::string unit;
        std::string how;    ///< how it was estimated, over what
        double wall_s = 0;  ///< s that the estimate took, of the module's own
    };

    std::string method;            ///< empty: the module integrates nothing
    std::uint64_t steps = 0;       ///< steps of that method
    std::size_t memory_bytes = 0;  ///< memory the module holds beyond its state block
    bool has_error = false;        ///< false: nothing is approximated over time
    Error error;
    std::vector<std::pair<std::string, MeasureValue>> measures;  ///< SI, in order of first mention

    void measure(std::string name, MeasureValue value) {
        measures.emplace_back(std::move(name), std::move(value));
    }
};

}  // namespace orbweaver
