#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace orbweaver {

/// A unit as a product of powers of kg, m, s, rad and px, times factor * 10^exponent.
struct Unit {
    std::array<int, 5> powers{};
    int exponent = 0;
    double factor = 1;

    bool same_dimension(const Unit& other) const noexcept { return powers == other.powers; }
};

/// "N s/m", "mm", "kg/m3", "m/s^2", "deg", "1". A '/' divides by the one factor behind it. Nothing when a
/// symbol is not known.
std::optional<Unit> parse_unit(std::string_view text);

struct Quantity {
    double value = 0;  ///< as written
    Unit unit;
    bool has_unit = false;
};

/// "7 mm", "1/60 s", "1e-8 N s/m", "12". Nothing when it is not a number followed by a known unit.
std::optional<Quantity> parse_quantity(std::string_view text);

/// The value counted in `unit`; the dimensions must agree. Decimal prefixes are exact: 7 mm gives 0.007.
double convert(const Quantity& quantity, const Unit& unit) noexcept;

}  // namespace orbweaver
