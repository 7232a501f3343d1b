#pragma once

#include <numbers>

#include "real.hpp"

namespace orbweaver::spider {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kDegree = kPi / 180;  // rad

/// A turn in a plane, as cosine and sine.
template <class Real>
struct Rotor {
    Real c, s;
};

template <class Real>
ORBWEAVER_INLINE Rotor<Real> operator*(const Rotor<Real>& a, const Rotor<Real>& b) noexcept {
    return {a.c * b.c - a.s * b.s, a.s * b.c + a.c * b.s};
}

/// The turn by `angle`, which is in [-pi, pi] rad. Absolute error below 2e-15; only + - *, so the same bits
/// everywhere. A quarter of the angle is within pi/4, where short polynomials do (minimax, as in fdlibm's
/// kernels of 1993); doubling it twice needs no decision about quadrants, and so no lane waits for another.
template <class Real>
ORBWEAVER_INLINE Rotor<Real> rotor(const Real& angle) noexcept {
    const Real t = 0.25 * angle;
    const Real q = t * t;
    const Real s =
        t + t * q *
                (-1.66666666666666324348e-01 +
                 q * (8.33333333332248946124e-03 +
                      q * (-1.98412698298579493134e-04 +
                           q * (2.75573137070700676789e-06 +
                                q * (-2.50507602534068634195e-08 + q * 1.58969099521155010221e-10)))));
    const Real versed =  // 1 - cos t
        q * (0.5 - q * (4.16666666666666019037e-02 +
                        q * (-1.38888888888741095749e-03 +
                             q * (2.48015872894767294178e-05 +
                                  q * (-2.75573143513906633035e-07 +
                                       q * (2.08757232129817482790e-09 - q * 1.13596475577881948265e-11))))));
    const Real s2 = 2 * s * (1 - versed), c2 = 1 - 2 * s * s;  // of half the angle
    return {1 - 2 * s2 * s2, 2 * s2 * c2};
}

/// The angle of the direction (c, s), in [-pi, pi] rad; 0 where it has none. Error below 1e-15. By Newton's
/// iteration on rotor(), from a start that is off by less than 0.04 rad.
inline double angle_of(double c, double s) noexcept {
    const double size = sqrt(c * c + s * s);
    if (!(size > 0)) return 0;
    c /= size;
    s /= size;
    const double along = c < 0 ? -c : c, across = s < 0 ? -s : s;
    const double ratio = along > across ? across / along : along / across;
    double angle = ratio * (kPi / 4 + 0.273 * (1 - ratio));
    if (across > along) angle = kPi / 2 - angle;
    for (int i = 0; i < 3; ++i) {
        const Rotor<double> at = rotor(angle);
        angle += across * at.c - along * at.s;
    }
    if (c < 0) angle = kPi - angle;
    return s < 0 ? -angle : angle;
}

}  // namespace orbweaver::spider
