#include "body_shape.hpp"

#include <algorithm>

#include "orbweaver/exact_math.hpp"
#include "species.hpp"

namespace orbweaver::spider {
namespace {

using Axes = std::array<double, 3>;

Vec3 vector_of(const Axes& a) noexcept { return {a[0], a[1], a[2]}; }

/// Half axes of an ellipsoid, and which of them is the shortest: its medial disk lies across that one.
struct Halves {
    Axes axes;
    std::size_t thin, first, second;
};

Halves halves_of(const Vec3& extents) noexcept {
    const Axes axes{extents.x / 2, extents.y / 2, extents.z / 2};
    const auto thin = static_cast<std::size_t>(std::min_element(axes.begin(), axes.end()) - axes.begin());
    return {axes, thin, (thin + 1) % 3, (thin + 2) % 3};
}

/// On the medial disk, `out` of the way to its rim: half axes (e^2 - s^2)/e, with s the shortest; the largest
/// ball there has the radius s sqrt(1 - sum x^2/(e^2 - s^2)).
Ball medial_ball(const Halves& halves, double out, double degrees) noexcept {
    const double s = halves.axes[halves.thin];
    Axes at{};
    double left = 1;
    const auto place = [&](std::size_t axis, double share) {
        const double e = halves.axes[axis];
        at[axis] = share * (e * e - s * s) / e;
        left -= share * share * (e * e - s * s) / (e * e);
    };
    place(halves.first, out * cos_degrees(degrees));
    place(halves.second, out * sin_degrees(degrees));
    return {vector_of(at), s * std::sqrt(std::max(0.0, left))};
}

/// m, from a point to the nearest ball.
double gap_to(const std::vector<Ball>& balls, const Vec3& point) noexcept {
    double least = HUGE_VAL;
    for (const Ball& ball : balls) least = std::min(least, distance(point, ball.center) - ball.radius);
    return least;
}

/// m, the largest gap between the ellipsoid and the balls in it: looked for at points three degrees apart.
double largest_gap(const Halves& halves, const std::vector<Ball>& balls) noexcept {
    constexpr int kApart = 3;  // degrees
    double largest = 0;
    for (int latitude = -90; latitude <= 90; latitude += kApart)
        for (int longitude = 0; longitude < 360; longitude += kApart) {
            const double level = cos_degrees(latitude);
            const Vec3 point{halves.axes[0] * level * cos_degrees(longitude),
                             halves.axes[1] * sin_degrees(latitude),
                             halves.axes[2] * level * sin_degrees(longitude)};
            largest = std::max(largest, gap_to(balls, point));
        }
    constexpr double kBetween = 1.1;  // what points so far apart may miss
    return kBetween * largest;
}

}  // namespace

BodyPart ellipsoid_of_balls(const Vec3& middle, const Vec3& extents) {
    struct Ring {
        double out;
        int balls;
    };
    constexpr std::array<Ring, 4> kRings{{{0, 1}, {0.4, 6}, {0.7, 10}, {0.93, 14}}};
    const Halves halves = halves_of(extents);
    BodyPart part;
    for (const Ring& ring : kRings)
        for (int i = 0; i < ring.balls; ++i)
            part.balls.push_back(medial_ball(halves, ring.out, 360.0 * i / ring.balls));
    const double grown = largest_gap(halves, part.balls);
    for (Ball& ball : part.balls) {
        ball.radius += grown;
        part.around.radius = std::max(part.around.radius, norm(ball.center) + ball.radius);
        ball.center += middle;
    }
    part.around.center = middle;
    return part;
}

BodyShape shape_of(const Body& body) {
    const double front = body.thorax.x / 2;
    const std::array<Vec3, 3> extents{body.thorax, body.head, body.abdomen};
    const std::array<Vec3, 3> middles{
        {{0, 0, 0}, {front + body.head.x / 2, 0, 0}, {-front - body.abdomen.x / 2, 0, 0}}};
    BodyShape shape;
    shape.hinge = -front;
    double total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        shape.parts[i] = ellipsoid_of_balls(middles[i], extents[i]);
        const double volume = extents[i].x * extents[i].y * extents[i].z;
        shape.center_of_mass += volume * middles[i];
        total += volume;
    }
    shape.center_of_mass *= 1 / total;
    return shape;
}

Vec3 bent(const BodyShape& shape, const Rotor<double>& bend, const Vec3& point) noexcept {
    const double x = point.x - shape.hinge;
    return {shape.hinge + bend.c * x + bend.s * point.y, bend.c * point.y - bend.s * x, point.z};
}

double depth_of(const BodyShape& shape) noexcept {
    double deepest = 0;
    for (const BodyPart& part : shape.parts)
        for (const Ball& ball : part.balls) deepest = std::max(deepest, ball.radius - ball.center.y);
    return deepest;
}

}  // namespace orbweaver::spider
