#pragma once

#include <optional>

#include "layout.hpp"
#include "mass_spring/network.hpp"
#include "orbweaver/diagnostic.hpp"

namespace orbweaver::web {

/// Threads with their springs, ready to move: spring i is the layout's piece i, and layout.positions are
/// where the particles start.
struct Web {
    Layout layout;
    mass_spring::Network network;
};

}  // namespace orbweaver::web
