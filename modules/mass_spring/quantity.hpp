#pragma once

#include <string>

namespace orbweaver::mass_spring {

/// A number as sentences show it: four significant digits.
std::string number_text(double value);
/// A time in s, ms, us or ns, whichever reads best.
std::string seconds_text(double seconds);

}  // namespace orbweaver::mass_spring
