#include "thread_pass.hpp"

#include <cmath>
#include <numbers>

#include "frame_target.hpp"
#include "offscreen.hpp"
#include "picture/color.hpp"
#include "sky_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 96;
constexpr Camera kCamera{{0, 0, 1}, {0, 0, 0}, 90};  // half a picture's height at the origin is 1 m
constexpr double kMetre = kSize / 2.0;               // px of a metre at the origin

struct Strands final : Threads {
    std::vector<Vec3> at;
    std::vector<ThreadSegment> pieces;
    std::uint64_t revised = 1;
    std::span<const Vec3> points() const noexcept override { return at; }
    std::span<const ThreadSegment> segments() const noexcept override { return pieces; }
    std::span<const std::string_view> kinds() const noexcept override { return {}; }
    std::uint64_t revision() const noexcept override { return revised; }
};

/// A strand through (x, 0) that leans by `angle` from upright and leaves the picture at both ends.
Strands strand(double x, double angle) {
    Strands s;
    const Vec3 along = Vec3{std::sin(angle), std::cos(angle), 0} * 3;
    s.at = {Vec3{x, 0, 0} - along, Vec3{x, 0, 0}, Vec3{x, 0, 0} + along};
    s.pieces = {{0, 1, 0}, {1, 2, 0}};
    return s;
}

class Studio {
public:
    Studio() : canvas_(kSize, kSize), target_(canvas_.gl, kSize, kSize), night_(canvas_.gl, night()) {}

    /// Linear light of the red channel, rows from the top.
    std::vector<double> draw(ThreadPass& pass, const Camera& camera = kCamera) {
        target_.bind();
        night_.draw(camera, 1);
        pass.draw(camera, kSize, kSize);
        std::vector<std::uint8_t> rgb;
        target_.read(rgb);
        const auto table = picture::linear_from_byte();
        std::vector<double> light;
        for (std::size_t i = 0; i < rgb.size(); i += 3) light.push_back(table[rgb[i]]);
        return light;
    }
    std::vector<double> draw(const Threads& threads, const ThreadLook& look) {
        ThreadPass pass(canvas_.gl, threads, look);
        return draw(pass);
    }
    const Gl& gl() const { return canvas_.gl; }

private:
    static CubeSky night() {
        CubeSky sky;
        sky.size = 1;
        for (auto& face : sky.faces) face.assign(3, 0.0F);
        return sky;
    }
    test::Offscreen canvas_;
    FrameTarget target_;
    SkyPass night_;
};

double sum_of_row(const std::vector<double>& light, int y) {
    double sum = 0;
    for (int x = 0; x < kSize; ++x) sum += light[static_cast<std::size_t>(y * kSize + x)];
    return sum;
}

double center_of_row(const std::vector<double>& light, int y) {
    double moment = 0;
    for (int x = 0; x < kSize; ++x) moment += (x + 0.5) * light[static_cast<std::size_t>(y * kSize + x)];
    return moment / sum_of_row(light, y);
}

}  // namespace

TEST_CASE("a thread adds light in proportion to its width, below a pixel too", "[image]") {
    Studio studio;
    for (const double width_px : {0.2, 0.5, 0.8, 1.0, 1.7, 4.0}) {
        for (const double degrees : {0.0, 10.0, 30.0, 44.0}) {
            const double angle = degrees * std::numbers::pi / 180;
            const auto light = studio.draw(strand(0.0137, angle), {width_px / kMetre, {1, 1, 1}, 1});
            double mean = 0;
            for (int y = 20; y < kSize - 20; ++y) mean += sum_of_row(light, y) / (kSize - 40);
            INFO(width_px << " px, " << degrees << " degrees");
            // A row cuts a leaning thread over width / cos. 8-bit shades and pixel centers cost up to 3 %.
            CHECK(mean == Approx(width_px / std::cos(angle)).epsilon(0.03));
        }
    }
}

TEST_CASE("a thread of more silk than others is drawn as much wider", "[image]") {
    Studio studio;
    Strands threads = strand(0.0137, 0);
    for (ThreadSegment& piece : threads.pieces) piece.width = 3;
    const auto light = studio.draw(threads, {0.4 / kMetre, {1, 1, 1}, 1});
    CHECK(sum_of_row(light, 30) == Approx(1.2).epsilon(0.03));
}

TEST_CASE("a thread lies where the pinhole equation puts it", "[image]") {
    Studio studio;
    const double angle = 0.3;
    const auto threads = strand(-0.21, angle);
    const auto light = studio.draw(threads, {0.7 / kMetre, {1, 1, 1}, 1});
    for (int y = 5; y < kSize - 5; ++y) {
        const double height = (kSize / 2.0 - (y + 0.5)) / kMetre;
        const auto landing = project(kCamera, {-0.21 + height * std::tan(angle), height, 0}, kSize, kSize);
        CHECK(std::abs(center_of_row(light, y) - landing.x) < 0.1);  // half a pixel would show as a step
    }
}

TEST_CASE("pieces of a straight thread meet without gap or bead", "[image]") {
    Studio studio;
    const auto light = studio.draw(strand(0.01, 0), {2 / kMetre, {1, 1, 1}, 0.7});
    for (int y = 10; y < kSize - 10; ++y) CHECK(sum_of_row(light, y) == Approx(1.4).epsilon(0.03));
}

TEST_CASE("opacity and color blend in linear light", "[image]") {
    Studio studio;
    const auto light = studio.draw(strand(0.5 / kMetre, 0), {6 / kMetre, {0.86, 0.86, 0.86}, 0.7});
    const double expected = 0.7 * picture::linear_from_srgb(0.86F);
    CHECK(light[static_cast<std::size_t>(kSize / 2 * kSize + kSize / 2)] == Approx(expected).epsilon(0.02));
}

TEST_CASE("a thread is thinner, and so fainter, farther away", "[image]") {
    Studio studio;
    Strands far = strand(0, 0);
    for (Vec3& p : far.at) p = p * 3 + Vec3{0, 0, -2};  // three times the distance
    const auto light = studio.draw(far, {1.5 / kMetre, {1, 1, 1}, 1});
    CHECK(sum_of_row(light, 30) == Approx(0.5).epsilon(0.03));
}

TEST_CASE("a thread that passes the camera is cut, not turned over", "[image]") {
    Studio studio;
    Strands past;
    past.at = {{0, -0.3, -4}, {0, -0.3, 9}};  // under the camera from far ahead to far behind
    past.pieces = {{0, 1, 0}};
    const auto light = studio.draw(past, {2 / kMetre, {1, 1, 1}, 1});
    CHECK(sum_of_row(light, kSize - 1) > 1);
    for (int y = 0; y < kSize / 2; ++y) CHECK(sum_of_row(light, y) == 0);

    Strands behind;
    behind.at = {{0, -1, 3}, {0, 1, 5}};
    behind.pieces = {{0, 1, 0}};
    for (const double l : studio.draw(behind, {2 / kMetre, {1, 1, 1}, 1})) CHECK(l == 0);
}

TEST_CASE("points move every picture, segments when the revision changes", "[image]") {
    Studio studio;
    Strands threads = strand(0, 0);
    ThreadPass pass(studio.gl(), threads, {2 / kMetre, {1, 1, 1}, 1});
    CHECK(center_of_row(studio.draw(pass), 40) == Approx(48).margin(0.1));
    for (Vec3& p : threads.at) p.x += 0.25;
    CHECK(center_of_row(studio.draw(pass), 40) == Approx(60).margin(0.1));
    threads.pieces.pop_back();  // the upper half
    ++threads.revised;
    const auto light = studio.draw(pass);
    CHECK(sum_of_row(light, 40) == 0);
    CHECK(sum_of_row(light, 60) > 1);
}

TEST_CASE("threads far from the scene's origin are as crisp as near it", "[extreme]") {
    Studio studio;
    Strands threads = strand(0, 0.2);
    const auto near = studio.draw(threads, {1 / kMetre, {1, 1, 1}, 1});
    const Vec3 away{1e5, -2e5, 3e4};
    for (Vec3& p : threads.at) p += away;
    ThreadPass pass(studio.gl(), threads, {1 / kMetre, {1, 1, 1}, 1});
    const auto far = studio.draw(pass, {kCamera.position + away, kCamera.target + away, kCamera.fov_degrees});
    for (std::size_t i = 0; i < near.size(); ++i) CHECK(far[i] == Approx(near[i]).margin(0.01));
}

TEST_CASE("no threads, no points, threads of no length: nothing is drawn", "[extreme]") {
    Studio studio;
    Strands none;
    for (const double l : studio.draw(none, {1, {1, 1, 1}, 1})) CHECK(l == 0);
    Strands dot;
    dot.at = {{0, 0, 0}, {0, 0, 0}};
    dot.pieces = {{0, 1, 0}, {0, 0, 0}};
    for (const double l : studio.draw(dot, {1 / kMetre, {1, 1, 1}, 1})) CHECK(l == 0);
}
