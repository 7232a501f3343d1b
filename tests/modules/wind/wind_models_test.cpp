#include "wind_models.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace orbweaver;
using namespace orbweaver::wind;

namespace {

constexpr double kStrength = 1e-8 * 9.8 * 10;  // the figure's WIND
constexpr double kHub = 1.0;                   // exp(0)

struct Sample {
    std::vector<Vec3> velocity;
    std::vector<Vec3> force;
};

Sample sample(const WindField& field, double time, const std::vector<Vec3>& positions, double radius = 0.3) {
    Sample found{std::vector<Vec3>(positions.size(), Vec3{9, 9, 9}),
                 std::vector<Vec3>(positions.size(), Vec3{9, 9, 9})};
    field.sample({time, positions, {0, 0, 0}, radius}, found.velocity, found.force);
    return found;
}

ThesisWind thesis_wind() { return {kStrength, 50, RandomStream(7, "wind/direction")}; }

}  // namespace

TEST_CASE("calm air neither moves nor pushes", "[unit]") {
    const Sample found = sample(CalmWind{}, 3, {{1, 2, 3}, {4, 5, 6}});
    CHECK(found.velocity == std::vector<Vec3>(2));
    CHECK(found.force == std::vector<Vec3>(2));
}

TEST_CASE("a steady wind has its velocity everywhere and always", "[unit]") {
    const SteadyWind field({1, 0.5, -2});
    for (const double time : {0.0, 7.3}) {
        const Sample found = sample(field, time, {{1, 2, 3}, {4, 5, 6}});
        CHECK(found.velocity == std::vector<Vec3>(2, Vec3{1, 0.5, -2}));
        CHECK(found.force == std::vector<Vec3>(2));
    }
}

TEST_CASE("the generator's wind has the values of figure 5.45, computed by hand", "[unit]") {
    const ThesisWind field = thesis_wind();
    const RandomStream random(7, "wind/direction");
    CHECK(field.wind_vector(0) == Vec3{0, 0, 0});  // sin(0)
    // t = 0.6 s: degree 30, sin = 0.5, first random number
    CHECK(field.wind_vector(0.6).z == Approx(-4.9e-7));
    CHECK(field.wind_vector(0.6).x == Approx(random.uniform(0, -3, 3) * 4.9e-7));
    CHECK(field.wind_vector(0.6).y == field.wind_vector(0.6).x);
    // t = 1.8 s: degree 90, sin = 1, second random number
    CHECK(field.wind_vector(1.8).z == Approx(-9.8e-7));
    CHECK(field.wind_vector(1.8).x == Approx(random.uniform(1, -3, 3) * 9.8e-7));
    // t = 4.2 s: degree 210, sin = -0.5, fifth random number
    CHECK(field.wind_vector(4.2).z == Approx(4.9e-7));
    CHECK(field.wind_vector(4.2).x == Approx(random.uniform(4, -3, 3) * -4.9e-7));
}

TEST_CASE("a new random number comes every fifty degrees, and stays within three", "[unit]") {
    const ThesisWind field = thesis_wind();
    const auto random = [&](int degree) {
        const Vec3 wind = field.wind_vector(degree * 0.02);
        return wind.x / -wind.z;
    };
    CHECK(random(1) == Approx(random(49)));
    CHECK(random(50) == Approx(random(99)));
    CHECK(random(49) != Approx(random(50)));
    for (int degree = 10; degree < 5000; degree += 50) {
        if (degree % 180 == 0) continue;  // no wind to divide by
        CHECK(random(degree) >= -3);
        CHECK(random(degree) < 3);
    }
}

TEST_CASE("the angle advances by one degree every 0.02 s, whatever the rounding of time", "[unit]") {
    const ThesisWind field = thesis_wind();
    for (int n = 1; n < 2000; ++n) {
        const double early = n * 0.02;          // frames of 0.02 s
        const double late = n * 0.02 + 0.0199;  // just before the next degree
        CHECK(field.wind_vector(early) == field.wind_vector(late));
    }
}

TEST_CASE("force grows with distance from the hub by exp(d/(50 R)), two percent at the rim", "[unit]") {
    const ThesisWind field = thesis_wind();
    const Vec3 wind = field.wind_vector(1.8);
    const Sample found = sample(field, 1.8, {{0, 0, 0}, {0.15, 0, 0}, {0, 0.3, 0}});
    CHECK(found.velocity == std::vector<Vec3>(3));
    CHECK(found.force[0].z == Approx(wind.z * kHub));
    CHECK(found.force[1].z == Approx(wind.z * 1.0100501670841680));  // e^0.01
    CHECK(found.force[2].z == Approx(wind.z * 1.0202013400267558));  // e^0.02
    CHECK(found.force[2].x == Approx(wind.x * 1.0202013400267558));
}

TEST_CASE("a body without extent feels the bare wind", "[unit]") {
    CHECK(sample(thesis_wind(), 1.8, {{0, 0, 0}}, 0).force[0] == thesis_wind().wind_vector(1.8));
}

TEST_CASE("the same time gives the same wind, another seed another", "[unit]") {
    CHECK(thesis_wind().wind_vector(12.3) == thesis_wind().wind_vector(12.3));
    CHECK(ThesisWind(kStrength, 50, RandomStream(8, "wind/direction")).wind_vector(1.8) !=
          thesis_wind().wind_vector(1.8));
}
