#pragma once

namespace orbweaver {

/// Elementary functions made of +, -, * and / alone, so that they give the same bits with every C
/// library and compiler: use them wherever the result reaches a hashed state.

/// sin of an angle in degrees; absolute error below 1e-15 for |degrees| < 1e9.
double sin_degrees(double degrees) noexcept;
/// cos of an angle in degrees; absolute error below 1e-15 for |degrees| < 1e9.
double cos_degrees(double degrees) noexcept;
/// e^x; relative error below 1e-14 for |x| < 700, else 0 or infinity as the limit is.
double exponential(double x) noexcept;

}  // namespace orbweaver
