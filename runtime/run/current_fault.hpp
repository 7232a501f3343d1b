#pragma once

#include "orbweaver/fault.hpp"

namespace orbweaver {

/// The exception that is being handled, whatever it is, as a Fault. To be called within a catch block.
Fault current_fault();

}  // namespace orbweaver
