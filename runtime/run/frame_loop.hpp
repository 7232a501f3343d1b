#pragma once

#include <functional>

#include "run/interrupt.hpp"
#include "run/session.hpp"

namespace orbweaver {

struct LoopSettings {
    const Request& request;
    bool endless = false;
    bool quiet = false;
};

/// The number of frames that last `duration` seconds: the nearest whole number of steps, at least one
/// unless the duration is zero.
std::uint64_t frame_count(double duration, double step);

/// Whether a picture falls due at the end of a run's frame `index`: after the first, then at
/// `pictures_per_second` (0: every frame).
bool picture_due(std::uint64_t index, double step, double pictures_per_second);

/// Steps the session from where it is to its duration, drawing when asked; with a window, obeys its keys and
/// keeps to real time. `recorded` is called after every frame. False when it was interrupted or closed.
bool run_frames(Session& session, const LoopSettings& settings, const Interrupt& interrupt,
                const std::function<void()>& recorded);

}  // namespace orbweaver
