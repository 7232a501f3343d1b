#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace orbweaver {

/// Whether a consumer's modules are attached after a provider's: it needs, uses or collects what that provides.
bool wants(const Manifest& consumer, const Manifest& provider);

struct AttachOrder {
    std::vector<PlannedModule> modules;  ///< providers before consumers, ties by name; those of a circle last
    std::vector<std::string> circle;     ///< instances that wait for each other; empty: none
};

AttachOrder attach_order(std::vector<PlannedModule> modules);

}  // namespace orbweaver
