#pragma once

#include <array>
#include <vector>

#include "orbweaver/vec3.hpp"
#include "rotor.hpp"

namespace orbweaver::spider {

struct Body;

struct Ball {
    Vec3 center;        ///< m, body frame
    double radius = 0;  ///< m
};

/// An ellipsoid as a body's thorax, head or abdomen is one, made of balls: those of its medial disk (the
/// largest that fit within it touch it all around; Blum 1967), as many as leave little of it out, and grown by
/// what they leave out. The ellipsoid lies within their union, and so is clear of whatever all of them are
/// clear of.
struct BodyPart {
    Ball around;              ///< of the ellipsoid's middle, with all others in it
    std::vector<Ball> balls;  ///< from the middle outwards
};
/// Of one with its middle there and these extents (m).
BodyPart ellipsoid_of_balls(const Vec3& middle, const Vec3& extents);

/// How much room a body takes, and where its weight is: constants of a species.
struct BodyShape {
    std::array<BodyPart, 3> parts;  ///< thorax, head, abdomen
    double hinge = 0;               ///< m, body frame, along x: where the abdomen bends
    Vec3 center_of_mass;            ///< m, body frame; of the three, equally dense; legs are left out
};
BodyShape shape_of(const Body& body);

/// m, body frame: where a point of the unbent abdomen is when it is bent.
Vec3 bent(const BodyShape& shape, const Rotor<double>& bend, const Vec3& point) noexcept;

/// m, how far it reaches below the thorax's middle.
double depth_of(const BodyShape& shape) noexcept;

}  // namespace orbweaver::spider
