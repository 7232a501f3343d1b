#pragma once

#include <string>

#include "plan/catalog.hpp"

namespace orbweaver {

/// Prints the modules of a catalog, or one of them with its options. Returns the exit code.
int print_modules(const Catalog& catalog, const std::string& name);

}  // namespace orbweaver
