#include "body_shape.hpp"

#include <cmath>

#include "creatures.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;
using namespace orbweaver::spider::test;

namespace {

/// On the unit ball, two degrees apart.
std::vector<Vec3> directions() {
    std::vector<Vec3> all;
    for (int latitude = -90; latitude <= 90; latitude += 2)
        for (int longitude = 0; longitude < 360; longitude += 2) {
            const double a = latitude * kDegree, b = longitude * kDegree;
            all.push_back({std::cos(a) * std::cos(b), std::sin(a), std::cos(a) * std::sin(b)});
        }
    return all;
}

/// m, beyond the nearest ball of a part.
double beyond(const BodyPart& part, const Vec3& point) {
    double least = HUGE_VAL;
    for (const Ball& ball : part.balls) least = std::min(least, distance(ball.center, point) - ball.radius);
    return least;
}

}  // namespace

TEST_CASE("head, thorax and abdomen lie within their balls, and these stand out by little", "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        const Body& body = species.body;
        const Vec3 extents[] = {body.thorax, body.head, body.abdomen};
        const double front = body.thorax.x / 2;
        const double middles[] = {0, front + body.head.x / 2, -front - body.abdomen.x / 2};
        for (std::size_t i = 0; i < 3; ++i) {
            const BodyPart& part = species.shape.parts[i];
            const Vec3 half = 0.5 * extents[i];
            const double thin = std::min({half.x, half.y, half.z});
            double worst = -HUGE_VAL, largest = 0;
            for (const Vec3& d : directions()) {
                const Vec3 point{middles[i] + half.x * d.x, half.y * d.y, half.z * d.z};
                worst = std::max(worst, beyond(part, point));
                largest = std::max(largest, distance(point, part.around.center));
            }
            CHECK(worst <= 0);
            CHECK(part.around.radius >= largest);
            // Balls that fit within it reach nowhere beyond it, and are grown by a third of its half thickness,
            // or little more: what the flattest one here, a huntsman's thorax, leaves out between so few.
            for (const Ball& ball : part.balls) {
                CHECK(ball.radius <= thin * 1.36);
                CHECK(distance(ball.center, part.around.center) + ball.radius <=
                      part.around.radius * (1 + 1e-12));
            }
            CHECK(part.around.radius <= largest + 0.36 * thin);
        }
    }
}

TEST_CASE("a ball is made of balls in one place", "[unit]") {
    const BodyPart ball = ellipsoid_of_balls({1, 2, 3}, {0.2, 0.2, 0.2});
    for (const Ball& each : ball.balls) {
        CHECK(distance(each.center, {1, 2, 3}) < 1e-15);
        CHECK(each.radius == Approx(0.1).epsilon(1e-12));
    }
}

TEST_CASE("a body's weight is where those of its parts balance", "[unit]") {
    const Species huntsman = creature("huntsman");
    // By volume, mm: thorax 9 x 3 x 9 at 0, head 3 x 2.5 x 6 at 6, abdomen 12 x 5 x 8 at -10.5.
    const double expected = (45 * 6 - 480 * 10.5) / (243 + 45 + 480) * 1e-3;
    CHECK(huntsman.shape.center_of_mass.x == Approx(expected).epsilon(1e-12));
    CHECK(huntsman.shape.center_of_mass.y == 0);
    CHECK(huntsman.shape.center_of_mass.z == 0);
}

TEST_CASE("an abdomen bends about its hinge as its skeleton does", "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        const Vec3 tip{-species.body.thorax.x / 2 - species.body.abdomen.x, 0, 0};
        for (const double angle : {-0.8, 0.0, 0.5}) {
            const double length = species.body.abdomen.x;
            const Vec3 at = bent(species.shape, rotor(angle), tip);
            CHECK(at.x == Approx(-species.body.thorax.x / 2 - length * std::cos(angle)).epsilon(1e-12));
            CHECK(at.y == Approx(length * std::sin(angle)).margin(1e-15));
        }
    }
}

TEST_CASE("nobody drags its belly over level ground", "[unit]") {
    for (const std::string& name : kCreatures) {
        INFO(name);
        const Species species = creature(name);
        const Vec3& abdomen = species.body.abdomen;
        CHECK(depth_of(species.shape) >= abdomen.y / 2);
        CHECK(depth_of(species.shape) <= 1.36 * abdomen.y / 2);
        CHECK(species.carriage > 1.1 * depth_of(species.shape));
        CHECK(species.carriage >= species.height);
    }
}
