#include "surface_pass.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "build.hpp"
#include "frame_target.hpp"
#include "mesh_surface.hpp"
#include "offscreen.hpp"
#include "picture/color.hpp"
#include "shapes.hpp"
#include "sky_pass.hpp"
#include "thread_pass.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

constexpr int kSize = 64;

struct Built {
    mesh::Validation validation;
    mesh::SurfaceMeshData data;
    surface::MeshSurface surface;
    explicit Built(const mesh::RawMesh& raw, surface::GripOverrides grips = {})
        : data(mesh::build_surface_mesh(raw, {}, "the test's mesh", validation)),
          surface(data.view(), std::nullopt, std::move(grips)) {}
};

/// Each face of the sky has a light of its own: 0.1 to the right, 0.2 to the left, 0.3 above ...
CubeSky six_lights() {
    CubeSky sky;
    sky.size = 2;
    for (std::size_t f = 0; f < kFaces; ++f) sky.faces[f].assign(12, 0.1F * static_cast<float>(f + 1));
    return sky;
}

class Studio {
public:
    Studio() : canvas_(kSize, kSize), target_(canvas_.gl, kSize, kSize, FrameTarget::Depth::kept) {}

    /// Linear light of the middle pixel's red.
    double middle_of(const Surface& surface, const Camera& camera, const Threads* threads = nullptr) {
        const CubeSky lights = six_lights();
        CubeSky night = lights;
        for (auto& face : night.faces) std::fill(face.begin(), face.end(), 0.0F);
        const SkyPass sky(canvas_.gl, night);
        const SurfacePass pass(canvas_.gl, surface, {{1, 1, 1}, 0}, sky_light(lights));
        target_.bind();
        target_.clear_depths();
        sky.draw(camera, 1);
        pass.draw(camera, kSize, kSize);
        if (threads != nullptr)
            ThreadPass(canvas_.gl, *threads, {0.2, {0, 0, 0}, 1}).draw(camera, kSize, kSize);
        std::vector<std::uint8_t> rgb;
        target_.read(rgb);
        return picture::linear_from_byte()[rgb[std::size_t{3} * (kSize / 2 * kSize + kSize / 2)]];
    }
    const Gl& gl() const { return canvas_.gl; }

private:
    test::Offscreen canvas_;
    FrameTarget target_;
};

struct Strand final : Threads {
    std::vector<Vec3> at;
    std::vector<ThreadSegment> pieces = {{0, 1, 0}};
    explicit Strand(double z) : at{{-3, 0, z}, {3, 0, z}} {}
    std::span<const Vec3> points() const noexcept override { return at; }
    std::span<const ThreadSegment> segments() const noexcept override { return pieces; }
    std::span<const std::string_view> kinds() const noexcept override { return {}; }
    std::uint64_t revision() const noexcept override { return 1; }
};

}  // namespace

TEST_CASE("a face is lit by the part of the sky that it looks at", "[image]") {
    Studio studio;
    // From outside and, seen from its back, from inside: the side towards the viewer counts.
    const Built cube(mesh::cube(2, 3));
    const std::pair<Vec3, double> sides[] = {{{1, 0, 0}, 0.1},     {{-1, 0, 0}, 0.2}, {{0, 1, 1e-3}, 0.3},
                                             {{0, -1, 1e-3}, 0.4}, {{0, 0, -1}, 0.5}, {{0, 0, 1}, 0.6}};
    for (const auto& [side, light] : sides) {
        CAPTURE(light);
        const Camera camera{4 * side + Vec3{0.07, 0.05, 0.03}, {0.07, 0.05, 0.03}, 30};
        CHECK(studio.middle_of(cube.surface, camera) == Approx(light).margin(0.006));  // a shade of 8 bits
    }
    const Camera within{{0.1, 0.05, 0}, {0.3, 0.08, 1}, 60};
    CHECK(studio.middle_of(cube.surface, within) == Approx(0.5).margin(0.006));
    // A face that looks to the right and up, by half each: its normal's squares are the weights.
    mesh::RawMesh slope;
    slope.points = {{-1, 1, -1}, {-1, 1, 1}, {1, -1, 1}, {1, -1, -1}};
    slope.material_names = {"slope"};
    slope.add_polygon({0, 1, 2, 3});
    CHECK(studio.middle_of(Built(slope).surface, {{3, 3, 0.1}, {0, 0, 0}, 30}) == Approx(0.2).margin(0.006));
}

TEST_CASE("threads behind a surface are hidden, those before it are not", "[image]") {
    Studio studio;
    const Built cube(mesh::cube(2, 1));
    const Camera camera{{0, 0, 6}, {0, 0, 0}, 40};
    const Strand before(1.2), behind(-1.2), inside(0);
    CHECK(studio.middle_of(cube.surface, camera, &before) < 0.01);
    CHECK(studio.middle_of(cube.surface, camera, &behind) == Approx(0.6).margin(0.006));
    CHECK(studio.middle_of(cube.surface, camera, &inside) == Approx(0.6).margin(0.006));
}

TEST_CASE("what nobody can climb is marked, and tinted", "[image]") {
    Studio studio;
    const Camera camera{{0, 0, 5}, {0, 0, 0}, 30};
    surface::GripOverrides slippery;
    slippery.all = {0.1, false};
    const Built rock(mesh::cube(2, 2)), glass(mesh::cube(2, 2), slippery);
    for (const std::uint32_t code : corner_codes(rock.surface)) CHECK((code & 8) == 0);
    for (const std::uint32_t code : corner_codes(glass.surface)) CHECK((code & 8) == 8);
    CHECK(studio.middle_of(glass.surface, camera) < 0.8 * studio.middle_of(rock.surface, camera));
}

TEST_CASE("only edges of the source's polygons are marked, the cuts within them are not", "[unit]") {
    const Built quads(mesh::cube(2, 3));
    for (const std::uint32_t code : corner_codes(quads.surface)) CHECK(std::popcount(code & 7) == 2);
    const Built triangles(mesh::bow_tie(2, 2));
    const auto codes = corner_codes(triangles.surface);
    REQUIRE(codes.size() == 3 * triangles.data.triangles.size());
    for (std::size_t i = 0; i < codes.size(); ++i) {
        CHECK((codes[i] & 7) == 7);
        CHECK(codes[i] >> 4 == triangles.data.triangles[i / 3][i % 3]);
    }
    // The end of a branch is one polygon: of its fan only the rim is marked.
    const Built branch(mesh::branch(1, 1));
    std::size_t marked = 0;
    const auto of_branch = corner_codes(branch.surface);
    for (std::size_t i = 0; i < of_branch.size(); i += 3)
        marked += static_cast<std::size_t>(std::popcount(of_branch[i] & 7));
    CHECK(marked == 4 * 6 * 8 + 2 * 6);  // 6 x 8 quads, and two hexagons
}
