#pragma once

#include <string>
#include <vector>

namespace orbweaver {

/// The path of every shared object mapped into this process now, sorted; the program itself left out.
std::vector<std::string> loaded_libraries();

}  // namespace orbweaver
