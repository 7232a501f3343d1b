#include "patch_pass.hpp"

#include <algorithm>

#include "frame_target.hpp"
#include "offscreen.hpp"
#include "orbweaver/fault.hpp"
#include "picture/color.hpp"
#include "sky_pass.hpp"
#include "tubes.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 256;
constexpr double kMetres = 8;               // a side of the picture, where the tubes' axes are
constexpr double kFov = 4.581300751310184;  // of them, from 100 m away
constexpr Camera kFront{{0, 0, 100}, {0, 0, 0}, kFov};
constexpr double kShadeBits = 0.01;

/// A sky of which each face has one light: from +x, -x, +y, -y, -z, +z.
CubeSky faces(const std::array<float, kFaces>& lights) {
    CubeSky sky;
    sky.size = 2;
    for (std::size_t f = 0; f < kFaces; ++f) sky.faces[f].assign(12, lights[f]);
    return sky;
}
CubeSky even(float light) { return faces({light, light, light, light, light, light}); }

class Studio {
public:
    Studio() : canvas_(kSize, kSize), target_(canvas_.gl, kSize, kSize, FrameTarget::Depth::kept) {}

    void draw(Patches& patches, const Camera& camera = kFront, const CubeSky& lights = even(0.5F),
              float backdrop = 0) {
        target_.bind();
        target_.clear_depths();
        SkyPass(canvas_.gl, even(backdrop)).draw(camera, 1);
        PatchPoints points(canvas_.gl, patches);
        const PatchPass pass(canvas_.gl, patches, sky_light(lights), key_light(lights));
        points.update();
        pass.draw(points, camera, kSize, kSize);
        target_.read(rgb_);
    }
    /// Linear light at x m to the right of and y m above the picture's middle.
    double light(double x, double y, std::size_t channel = 0) const {
        const auto column = static_cast<std::size_t>((x / kMetres + 0.5) * kSize);
        const auto row = static_cast<std::size_t>((0.5 - y / kMetres) * kSize);
        return picture::linear_from_byte()[rgb_[3 * (row * kSize + column) + channel]];
    }
    /// m, how much of a line upwards through x is not black.
    double height(double x) const {
        double sum = 0;
        for (int row = 0; row < kSize; ++row)
            sum += light(x, (row + 0.5) * kMetres / kSize - kMetres / 2) > 0 ? kMetres / kSize : 0;
        return sum;
    }
    std::uint8_t darkest() const { return *std::min_element(rgb_.begin(), rgb_.end()); }
    std::uint8_t lightest() const { return *std::max_element(rgb_.begin(), rgb_.end()); }

private:
    test::Offscreen canvas_;
    FrameTarget target_;
    std::vector<std::uint8_t> rgb_;
};

/// Domes over both ends: the first ring is the third mirrored, the second the point between.
void round_off(test::Tubes& tube) {
    for (const auto& [outer, tip, inner] : {std::array{0U, 1U, 2U}, std::array{8U, 7U, 6U}}) {
        tube.collapse(tip);
        for (std::size_t i = 0; i < tube.shape.sides; ++i) {
            const Vec3& from = tube.ring(inner)[i];
            tube.ring(outer)[i] = {from.x, -from.y, -from.z};
            tube.ring(tip)[i].x = 4.0 / 3 * from.x;
        }
    }
}

/// Cones at both ends: three rings in one point.
void point(test::Tubes& tube) {
    for (const auto& [tip, rings] : {std::pair{2U, std::array{0U, 1U}}, std::pair{6U, std::array{7U, 8U}}}) {
        tube.collapse(tip);
        for (const std::size_t ring : rings) std::ranges::copy(tube.ring(tip), tube.ring(ring).begin());
    }
}

constexpr double kPixel = kMetres / kSize;
const double kHalfRight = std::sqrt(0.5);

}  // namespace

TEST_CASE("a tube is as thick as the closed B-spline around its rings, and as long as the open one",
          "[image]") {
    Studio studio;
    const auto check = [&](std::size_t sides, double turn, double radius) {
        CAPTURE(sides, turn);
        test::Tubes tube({{0, 0, 0}}, 9, sides, 1, turn);
        studio.draw(tube);
        for (const double x : {-2.9, -1.3, 0.0, 0.5, 2.9})
            CHECK(studio.height(x) == Approx(2 * radius).margin(1.5 * kPixel));
        for (const double x : {-3.1, 3.1}) CHECK(studio.height(x) == 0);
    };
    check(4, 0, 2.0 / 3);                                  // at a knot: (P + 4 P + P) / 6
    check(4, std::numbers::pi / 4, kHalfRight * 44 / 48);  // between: (P + 23 P + 23 P + P) / 48
    check(8, 0, 2.0 / 3 + kHalfRight / 3);
}

TEST_CASE("each body of patches is drawn where its points are", "[image]") {
    Studio studio;
    test::Tubes tubes({{0, 2, 0}, {1, -2, 0}}, 5, 8, 0.5);
    studio.draw(tubes);
    CHECK(studio.light(0, 2) > 0.1);
    CHECK(studio.light(-0.7, 2) > 0.1);
    CHECK(studio.light(1.7, -2) > 0.1);
    CHECK(studio.light(-0.7, -2) == 0);
    CHECK(studio.light(0, 0) == 0);
    for (Vec3& point : tubes.now) point += {1e7, 1e7, 0};  // far away nothing is coarser
    studio.draw(tubes, {{1e7, 1e7, 100}, {1e7, 1e7, 0}, kFov});
    CHECK(studio.height(-0.5) == Approx(2 * 0.5 * (2.0 / 3 + kHalfRight / 3)).margin(1.5 * kPixel));
}

TEST_CASE("nothing is drawn of patches where there are no bodies", "[image]") {
    Studio studio;
    test::Tubes none({}, 9, 8), few({{0, 0, 0}}, 3, 8), thin({{0, 0, 0}}, 9, 2), whole({{0, 0, 0}}, 9, 8);
    for (test::Tubes* each : {&none, &few, &thin}) {
        studio.draw(*each);
        CHECK(studio.lightest() == 0);
    }
    studio.draw(whole);
    CHECK(studio.lightest() > 0);
}

TEST_CASE("the light on a tube is that of the sky that its skin looks at", "[image]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    const auto sides = [&](const CubeSky& sky) {
        studio.draw(tube, kFront, sky);
        return std::array{studio.light(0, 0.6), studio.light(0, -0.6)};
    };
    const auto front = sides(faces({0, 0, 0, 0, 0, 0.5F}));  // alike above and below
    CHECK(front[0] == Approx(front[1]).margin(kShadeBits));
    CHECK(studio.light(-2, 0.6) == Approx(front[0]).margin(kShadeBits));
    CHECK(studio.light(0, 0) > front[0] + 0.05);
    const auto above = sides(faces({0, 0, 0.5F, 0, 0, 0})), below = sides(faces({0, 0, 0, 0.5F, 0, 0}));
    CHECK(above[0] == Approx(below[1]).margin(kShadeBits));
    CHECK(above[1] == Approx(below[0]).margin(kShadeBits));
    CHECK(above[0] > above[1] + 0.1);
}

TEST_CASE("the insides of tubes are not drawn", "[image]") {
    Studio studio;
    const Camera into{
        {8, 0, 0}, {3, 0, 0}, 77.31961650818018};  // 8 m at its open end, through which it sees walls
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    studio.draw(tube, into);
    CHECK(studio.lightest() == 0);
    for (std::size_t ring = 0; ring < tube.shape.rings; ++ring) std::ranges::reverse(tube.ring(ring));
    studio.draw(tube, into);  // inside out
    CHECK(studio.light(0, 0.7) > 0.1);
}

TEST_CASE("a map goes around a tube as its points do, and along it from tail to head", "[image]") {
    Studio studio;
    constexpr std::size_t kRed = 0, kBlue = 2;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    const std::vector<std::uint8_t> red{255, 0, 0, 0}, blue{0, 0, 255, 0};
    const auto map = [](const std::vector<std::vector<std::uint8_t>>& texels) {
        std::vector<std::uint8_t> all;
        for (const auto& texel : texels) all.insert(all.end(), texel.begin(), texel.end());
        return all;
    };
    tube.paint(4, 1, map({red, red, blue, blue}));
    studio.draw(tube);
    CHECK(studio.light(0, 0, kRed) > 0.2);
    CHECK(studio.light(0, 0, kBlue) < 0.05);
    studio.draw(tube, {{0, 0, -100}, {0, 0, 0}, kFov});  // from behind
    CHECK(studio.light(0, 0, kRed) < 0.05);
    CHECK(studio.light(0, 0, kBlue) > 0.2);
    studio.draw(tube, {{0, 100, 0.001}, {0, 0, 0}, kFov});  // from above: the first column follows the last
    CHECK(studio.light(0, 0, kRed) == Approx(studio.light(0, 0, kBlue)).margin(0.1));
    CHECK(studio.light(0, -0.6, kRed) > 4 * studio.light(0, -0.6, kBlue));
    tube.paint(1, 2, map({red, blue}));
    studio.draw(tube);
    CHECK(studio.light(-2.95, 0, kRed) > 0.2);
    CHECK(studio.light(-2.95, 0, kBlue) < 0.05);  // the last row does not follow the first
    CHECK(studio.light(2.95, 0, kBlue) > 0.2);
    CHECK(studio.light(0, 0, kRed) == Approx(studio.light(0, 0, kBlue)).margin(0.05));  // half of each
}

TEST_CASE("a map's colors are sRGB", "[image]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    studio.draw(tube);
    const double white = studio.light(0, 0);
    tube.paint(1, 1, {188, 188, 188, 0});
    studio.draw(tube);
    CHECK(studio.light(0, 0) / white == Approx(picture::linear_from_byte()[188]).margin(0.02));
}

TEST_CASE("where the map rises, skin looks back as far as the relief says", "[image]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    const auto middle = [&](const CubeSky& sky, double relief) {
        tube.wrap.relief = relief;
        studio.draw(tube, kFront, sky);
        return studio.light(0, 0);
    };
    const CubeSky left = faces({0, 0.5F, 0, 0, 0, 0}), right = faces({0.5F, 0, 0, 0, 0, 0});
    const CubeSky above = faces({0, 0, 0.5F, 0, 0, 0}), below = faces({0, 0, 0, 0.5F, 0, 0});

    tube.paint(1, 2, {255, 255, 255, 0, 255, 255, 255, 255});  // from tail to head, at half of 6 m: 1 in 3
    const double cosine = 1 / std::sqrt(10.0);
    CHECK(middle(left, 0) == Approx(middle(right, 0)).margin(kShadeBits));
    CHECK(middle(left, 0) == Approx(0.75 * 0.2 / 1.2).margin(0.02));
    CHECK(middle(left, 1) == Approx(0.45 * cosine * cosine + 0.75 * (cosine + 0.2) / 1.2).margin(0.02));
    CHECK(middle(right, 1) < 0.01);
    CHECK(middle(left, 0.3) < middle(left, 1) - 0.05);
    CHECK(middle(left, 0.3) > middle(left, 0) + 0.05);

    tube.paint(4, 1,
               {255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0});  // downwards
    CHECK(middle(above, 0) == Approx(middle(below, 0)).margin(0.03));  // half a pixel from the middle
    CHECK(middle(above, 0.5) > middle(above, 0) + 0.05);
    CHECK(middle(below, 0.5) < middle(below, 0) - 0.05);
    const double slope = 0.5 * 4 / (8 * kHalfRight),
                 sine = slope / std::sqrt(1 + slope * slope);  // (P - P) / 2
    CHECK(middle(above, 0.5) == Approx(0.45 * sine * sine + 0.75 * (sine + 0.2) / 1.2).margin(0.03));
}

TEST_CASE("a tube ends where its rings become a point, and looks out of its axis there", "[image]") {
    Studio studio;
    test::Tubes round({{0, 0, 0}}, 9, 8), pointed({{0, 0, 0}}, 9, 8);
    round_off(round);
    point(pointed);
    for (test::Tubes* each : {&round, &pointed})
        for (const Vec3& eye : {Vec3{-100, 0, 0}, Vec3{100, 0, 0}, Vec3{-70, 0, 70}, Vec3{0, 0, 100}}) {
            CAPTURE(eye.x, eye.z, each == &round);
            studio.draw(*each, {eye, {0, 0, 0}, kFov}, even(0.5F), 0.5F);
            CHECK(studio.darkest() > 100);  // what is no number is drawn black
        }
    studio.draw(round, {{-100, 0, 0}, {0, 0, 0}, kFov}, faces({0, 0.4F, 0, 0, 0, 0}));
    CHECK(studio.light(0, 0) == Approx(0.4 * (0.9 + 1.5 + 0.04)).margin(0.03));  // wholly lit
    studio.draw(round, {{100, 0, 0}, {0, 0, 0}, kFov}, faces({0.4F, 0, 0, 0, 0, 0}));
    CHECK(studio.light(0, 0) == Approx(0.4 * (0.9 + 1.5 + 0.04)).margin(0.03));
}

TEST_CASE("a relief that is drawn together to a point does not turn skin away from everything", "[image]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    round_off(tube);
    tube.paint(2, 1, {255, 255, 255, 0, 255, 255, 255, 255});
    tube.wrap.relief = 1;
    studio.draw(tube, {{100, 0, 0}, {0, 0, 0}, kFov}, faces({0.4F, 0, 0, 0, 0, 0}));
    const double cosine = 1 / std::sqrt(5.0);  // of a slope of 2
    for (const auto& [x, y] : {std::pair{0.05, 0.0}, {-0.05, 0.05}, {0.0, -0.05}, {0.1, 0.1}})
        CHECK(studio.light(x, y) > 0.4 * (0.9 * cosine * cosine + 1.5 * (cosine + 0.2) / 1.2) - 0.03);
}

TEST_CASE("a body of one point is drawn nowhere", "[extreme]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    std::ranges::fill(tube.now, Vec3{1, 1, 0});
    studio.draw(tube);
    CHECK(studio.lightest() == 0);
}

TEST_CASE("a map that is not as large as it says is told in a sentence", "[extreme]") {
    Studio studio;
    test::Tubes tube({{0, 0, 0}}, 9, 8);
    tube.wrap.rows = 2;
    CHECK_THROWS_WITH(studio.draw(tube), "A skin's map of 1 x 2 texels has 4 bytes.");
    tube.wrap.columns = 1U << 20U;
    CHECK_THROWS_AS(studio.draw(tube), Fault);
}
