#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "method.hpp"

namespace orbweaver::mass_spring {

/// What to do when the asked step is longer than the adviser's.
enum class OnUnstable : std::uint8_t { substep, stop, as_asked };
/// By the name that scenes give it; any other is `substep`.
inline OnUnstable on_unstable_named(std::string_view name) noexcept {
    if (name == "stop") return OnUnstable::stop;
    return name == "as_asked" ? OnUnstable::as_asked : OnUnstable::substep;
}

struct SimulationSettings {
    const MethodInfo* method = nullptr;
    double step = 0;  ///< s, asked substep; 0: the adviser's
    double tolerance =
        0;  ///< m, of one step of a method with an embedded order, which then chooses steps; 0: fixed
    OnUnstable on_unstable = OnUnstable::substep;
    std::int64_t max_substeps = 100000;  ///< of one frame, parts of steps that a method divides counted; more
                                         ///< is refused in words
    std::function<bool()> stop_asked;    ///< whether the frame is to be given up
    std::function<std::string(std::size_t)> describe_spring;  ///< "spring 12 (radius, 3 to 7)"
    std::function<void(const std::string&)> warn;             ///< receives full sentences
};

}  // namespace orbweaver::mass_spring
