#pragma once

#include <string>

#include "study/stability.hpp"

namespace orbweaver::study {

/// "method,<axis>,<axis>,class,reason", the axes named by the paths of their options.
std::string stability_csv(const StabilityResult& result);
std::string stability_json(const StabilityResult& result);
/// A map a method, the adviser's prediction over it as a line, and the scene's own point.
std::string stability_svg(const StabilityResult& result);
std::string stability_page(const StabilityResult& result);

}  // namespace orbweaver::study
