#pragma once

#include <cstdint>

#include "light.hpp"
#include "noise.hpp"

namespace orbweaver {

/// A direction of sight: degrees to the right of -z and above the horizon, and the unit vector of both.
struct Sight {
    double azimuth = 0;
    double elevation = 0;
    Vec3 direction;
};
Sight sight(double azimuth, double elevation);

/// The landscape without its lights and flowers: sky, clouds, hills, trees, grass.
class Meadow {
public:
    explicit Meadow(std::uint64_t seed) : noise_(seed) {}
    Light light(const Sight& s) const;
    /// How strongly the sun shines from there: 1 at its disk, fading over tens of degrees.
    static double glow(const Sight& s);

private:
    Light sky(const Sight& s) const;
    Light grass(const Sight& s) const;
    Light trees(const Sight& s) const;
    double ridge(const Sight& s, double low, double high, double detail, double shift) const;

    Noise noise_;
};

}  // namespace orbweaver
