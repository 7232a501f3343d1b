#pragma once

#include <string>

namespace orbweaver {

/// Where what scenes ask for is kept baked: $ORBWEAVER_CACHE, else $XDG_CACHE_HOME/orbweaver, else
/// ~/.cache/orbweaver. Throws Fault(invalid) where there is none of them.
std::string cache_folder();

}  // namespace orbweaver
