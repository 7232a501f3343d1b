#include "quantity.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace orbweaver::mass_spring {

std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return text.data();
}

std::string seconds_text(double seconds) {
    const double size = std::abs(seconds);
    if (size == 0 || size >= 1 || !std::isfinite(size)) return number_text(seconds) + " s";
    if (size >= 1e-3) return number_text(seconds * 1e3) + " ms";
    if (size >= 1e-6) return number_text(seconds * 1e6) + " us";
    return number_text(seconds * 1e9) + " ns";
}

}  // namespace orbweaver::mass_spring
