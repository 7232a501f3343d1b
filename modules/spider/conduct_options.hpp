#pragma once

#include <vector>

#include "command.hpp"
#include "creature.hpp"
#include "orbweaver/module.hpp"

namespace orbweaver::spider {

/// How creatures go about, as a table of the scene wants it. Points that it names are moved to where the
/// surface is nearest to them. Faults that the manifest cannot know of are reported to the host.
Conduct conduct_of(Host& host, const Surface& surface, const Species& species);

/// The table's `control`, in order of its begins.
std::vector<TimedCommand> control_of(const Options& options);

}  // namespace orbweaver::spider
