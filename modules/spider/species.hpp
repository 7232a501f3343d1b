#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "body_shape.hpp"
#include "leg.hpp"
#include "orbweaver/diagnostic.hpp"

namespace orbweaver::spider {

inline constexpr std::size_t kMaxLegs = 16;

/// A part that has a length and a thickness, m; length 0: there is none.
struct Rod {
    double length = 0;
    double thickness = 0;
};

/// Frame of a body: the thorax's middle is the origin, x forward, y up, z to the right. m.
struct Body {
    Vec3 head;  ///< length, height, width
    Vec3 thorax;
    Vec3 abdomen;
    double bend_min = 0;  ///< rad; between thorax and abdomen, up is positive
    double bend_max = 0;
    double waist = 0;     ///< m, thickness between thorax and abdomen
    Rod chelicera, palp;  ///< of each side, on the head
};

/// How it walks where a scene asks for nothing else: see PaceRange.
struct Walk {
    std::string gait;                ///< as find_gait() knows it
    double speed = 0;                ///< m/s, at most
    std::array<double, 2> duty{};    ///< of a cycle that a foot stands: at rest, at top speed
    std::array<double, 2> stride{};  ///< m, of the body in a cycle: the same
};

/// An eye, m, body frame.
struct Eye {
    Vec3 at;
    double radius = 0;
};

/// What it looks like. Shades are sRGB, [0, 1].
struct Coat {
    double leg = 0;       ///< m, thickness of a femur
    double hair = 0;      ///< m, length; 0: none
    double gloss = 0.25;  ///< 1, of carapace and legs: 0 dull, 1 polished
    Vec3 carapace{0.45, 0.36, 0.28}, abdomen{0.48, 0.39, 0.31}, legs{0.45, 0.36, 0.28};
    Vec3 marks{0.2, 0.15, 0.11};  ///< bands of legs, the abdomen's pattern
    Vec3 chelicerae{0.25, 0.17, 0.12};
    std::vector<Eye> eyes;  ///< of the right side; the left one is its mirror
};

/// A leg and where it is on the body.
struct Limb {
    std::string name;  ///< "R1": right, the first from the front
    Vec3 base;         ///< m, body frame
    Frame axes;        ///< of the leg's frame, in the body frame
    Leg leg;
    Vec3 home;    ///< m, body frame: the foot in the rest pose
    Vec3 stance;  ///< m, body frame: the foot in the middle of its stance, see stance_of()
};

/// What a kind of creature is made of.
struct Species {
    std::string name;
    Body body;
    BodyShape shape;  ///< of the body
    Walk walk;
    Coat coat;
    std::vector<Limb> limbs;  ///< R1 L1 R2 L2 ...
    double height = 0;        ///< m; the thorax's middle above the feet at rest, on average
    double carriage = 0;      ///< m; how high it is carried: so, or higher where its belly would drag
    double stance_radius =
        0;  ///< m; from it to feet in the middle of their stance, on average, along the ground
};

/// Of its limbs, in their order.
std::vector<Leg> legs_of(const Species& species);

/// m, of legs that are there.
double mean_leg_length(const Species& species) noexcept;

/// Where a foot stands in the middle of its stance: where it is at rest, but near enough to reach as far ahead
/// as behind.
Vec3 stance_of(const Limb& limb) noexcept;

/// A point from the body's frame into a limb's, and back.
Vec3 to_limb(const Limb& limb, const Vec3& point) noexcept;
Vec3 to_body(const Limb& limb, const Vec3& point) noexcept;

/// A species file (TOML; see the module's README). Nothing, and every fault with its place, when it is wrong.
std::optional<Species> read_species_file(const std::string& path, Diagnostics& faults);
/// `name` is what the species and the file in sentences are called.
std::optional<Species> read_species_text(const std::string& text, const std::string& name, Diagnostics& faults);

}  // namespace orbweaver::spider
