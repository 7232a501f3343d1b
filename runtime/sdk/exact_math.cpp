#include "orbweaver/exact_math.hpp"

#include <cmath>
#include <limits>

namespace orbweaver {

namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295769;

// Taylor series about 0; for |x| <= pi/4 the first left-out term is below 1e-17.
double sin_series(double x) noexcept {
    const double q = x * x;
    double sum = 0;
    for (int n = 17; n >= 3; n -= 2) sum = -q / (n * (n - 1)) * (1 + sum);
    return x * (1 + sum);
}

double cos_series(double x) noexcept {
    const double q = x * x;
    double sum = 0;
    for (int n = 18; n >= 2; n -= 2) sum = -q / (n * (n - 1)) * (1 + sum);
    return 1 + sum;
}

// sin of `degrees` + 90 `quarters`. Reduced in degrees, where a quarter turn is exact; fmod is exact too.
double sin_of(double degrees, int quarters) noexcept {
    if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
    const double turned = std::fmod(degrees, 360);
    const int nearest = static_cast<int>(std::floor((turned + 45) / 90));
    const double x = (turned - 90 * nearest) * kRadiansPerDegree;
    switch ((nearest + quarters) & 3) {
        case 0:
            return sin_series(x);
        case 1:
            return cos_series(x);
        case 2:
            return -sin_series(x);
        default:
            return -cos_series(x);
    }
}

}  // namespace

double sin_degrees(double degrees) noexcept { return sin_of(degrees, 0); }
double cos_degrees(double degrees) noexcept { return sin_of(degrees, 1); }

double exponential(double x) noexcept {
    if (std::isnan(x)) return x;
    if (x > 709) return std::numeric_limits<double>::infinity();
    if (x < -745) return 0;
    // e^x = 2^k e^r with |r| <= ln(2)/2; ln 2 in two parts keeps r exact.
    const double k = std::floor(x * 1.4426950408889634074 + 0.5);
    const double r = (x - k * 0.693147180369123816490) - k * 1.90821492927058770002e-10;
    double sum = 0;
    for (int n = 18; n >= 1; --n) sum = r / n * (1 + sum);
    return std::ldexp(1 + sum, static_cast<int>(k));
}

}  // namespace orbweaver
