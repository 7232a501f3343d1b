#pragma once

#include "orbweaver/module.hpp"
#include "sky.hpp"

namespace orbweaver::view {

/// The sky that the options `sky`, `sky_faces.*` and `exposure` ask for. Everything wrong with them goes to
/// host.report_fault(), and the plain sky is returned instead.
CubeSky load_sky(Host& host);

}  // namespace orbweaver::view
