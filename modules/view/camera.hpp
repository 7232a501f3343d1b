#pragma once

#include <array>
#include <span>

#include "orbweaver/vec3.hpp"

namespace orbweaver::view {

/// A pinhole camera in the scene's frame (right-handed, y up), upright.
struct Camera {
    Vec3 position;            ///< m
    Vec3 target;              ///< m, differs from position
    double fov_degrees = 40;  ///< vertical, whole angle
};

/// Unit vectors of the camera in the scene's frame.
struct CameraAxes {
    Vec3 right;
    Vec3 up;
    Vec3 forward;
};
CameraAxes axes(const Camera& camera);

/// tan(fov / 2): half the picture's height at unit depth.
double half_height(const Camera& camera);

/// Where a point lands: pixels from the picture's upper left corner, x right, y down, pixel centers at
/// halves; x = W/2 + f (p . right)/depth, y = H/2 - f (p . up)/depth, f = H / (2 tan(fov/2)).
struct Landing {
    double x = 0;
    double y = 0;
    double depth = 0;  ///< m along the view's axis; <= 0: behind the camera, x and y mean nothing
};
Landing project(const Camera& camera, const Vec3& point, int width, int height);

/// Scene to GL clip space, column by column; its w is the depth in metres.
std::array<float, 16> view_projection(const Camera& camera, double aspect, double near, double far);

/// m, between which things are drawn: parts of the distance to the target.
struct ClipDepths {
    double near = 0;
    double far = 0;
};
ClipDepths clip_depths(const Camera& camera);

/// Turns about the target: `x` and `y` are fractions of the picture dragged, right and up positive; one
/// picture's width is half a turn. Stops short of the poles.
Camera orbit(const Camera& camera, double x, double y);
/// Goes nearer (notches > 0) or farther, a tenth of the distance each.
Camera zoom(const Camera& camera, double notches);

/// The camera on the +z side of `target` that has every point in the picture with a margin.
Camera frame_points(std::span<const Vec3> points, const Vec3& target, double fov_degrees, double aspect);
/// The middle of the points' bounding box; the origin for none.
Vec3 middle(std::span<const Vec3> points);

}  // namespace orbweaver::view
