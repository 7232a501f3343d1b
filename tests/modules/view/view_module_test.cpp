#include <catch2/catch.hpp>
#include <cstdlib>

#include "build.hpp"
#include "fake_host.hpp"
#include "mesh_surface.hpp"
#include "orbweaver/contracts/canvas.hpp"
#include "orbweaver/contracts/input.hpp"
#include "orbweaver/contracts/picture_source.hpp"
#include "orbweaver/contracts/threads.hpp"
#include "plates.hpp"
#include "shapes.hpp"
#include "tubes.hpp"

using namespace orbweaver;

namespace {

struct Cross final : Threads {
    std::vector<Vec3> at = {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
    std::vector<ThreadSegment> pieces = {{0, 1, 0}, {2, 3, 0}};
    std::span<const Vec3> points() const noexcept override { return at; }
    std::span<const ThreadSegment> segments() const noexcept override { return pieces; }
    std::span<const std::string_view> kinds() const noexcept override { return {}; }
    std::uint64_t revision() const noexcept override { return 1; }
};

struct Hand final : Input {
    InputEvents events;
    const InputEvents& poll() noexcept override { return events; }
    const InputEvents& latest() const noexcept override { return events; }
    const char* key_list() const noexcept override { return ""; }
};

struct Stage {
    Stage() {
        host.scene_.name = "test";
        host.set("size", std::vector<double>{64, 48});
        host.set("exposure", 1.0);
        host.set("camera.fov", 40.0);
        host.set("thread.width", 0.2);
        host.set("thread.color", Vec3{1, 1, 1});
        host.set("thread.alpha", 1.0);
        host.offer<Threads>(cross);
        host.offer<Input>(hand);
    }
    std::span<const std::uint8_t> picture() {
        REQUIRE(view.run());
        return host.find<PictureSource>()->rgb();
    }
    Cross cross;
    Hand hand;
    test::FakeHost host;
    test::LoadedModule canvas{"canvas_osmesa"};
    test::LoadedModule view{"view"};
};

std::uint8_t red(std::span<const std::uint8_t> rgb, std::size_t width, std::size_t x, std::size_t y) {
    return rgb[3 * (y * width + x)];
}

}  // namespace

TEST_CASE("the view draws threads over the sky, framed when no camera is given", "[image]") {
    Stage stage;
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE(stage.view.attach(stage.host));
    const auto rgb = stage.picture();
    REQUIRE(rgb.size() == 64 * 48 * 3);
    CHECK(red(rgb, 64, 32, 24) > 240);
    CHECK(red(rgb, 64, 32, 3) > 200);  // the cross reaches nearly to the upper edge
    CHECK(red(rgb, 64, 5, 5) < 120);   // plain sky
    CHECK(stage.view.report().measures[0].first == "pictures");
}

TEST_CASE("a surface is drawn where there is one, and the camera has it in the picture", "[image]") {
    mesh::Validation validation;
    const auto data = mesh::build_surface_mesh(mesh::cube(6, 2), {}, "the test's cube", validation);
    surface::MeshSurface cube(data.view(), std::nullopt, {});
    Stage bare, stage;
    for (Stage* each : {&bare, &stage}) each->host.set("thread.color", Vec3{1, 0, 0});
    stage.host.set("surface.color", Vec3{1, 1, 1});
    stage.host.set("surface.edges", 0.0);
    stage.host.offer<Surface>(cube);
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE(stage.view.attach(stage.host));
    const auto rgb = stage.picture();
    const auto green = [&](std::size_t x, std::size_t y) { return rgb[3 * (y * 64 + x) + 1]; };
    CHECK(green(32, 24) > 0);               // the cube's front hides the red cross within it
    CHECK(green(32, 24) == green(40, 30));  // in one shade
    CHECK(green(2, 2) != green(32, 24));    // beside it is the sky
    const std::size_t drawn = stage.view.report().memory_bytes;
    REQUIRE(bare.canvas.attach(bare.host));
    REQUIRE(bare.view.attach(bare.host));
    bare.picture();
    CHECK(drawn > bare.view.report().memory_bytes);  // no depths are kept for threads alone
}

TEST_CASE("bodies with a skin are drawn where there are any, and cost nothing where there are none",
          "[image]") {
    Stage bare, stage;
    test::Plates plates({{0.5, 0.5, 0}});
    stage.host.offer<Skins>(plates);
    for (Stage* each : {&bare, &stage}) {
        each->host.set("thread.color", Vec3{0, 0, 1});
        REQUIRE(each->canvas.attach(each->host));
        REQUIRE(each->view.attach(each->host));
    }
    const auto before = bare.picture(), rgb = stage.picture();
    const auto at = [](std::size_t x, std::size_t y) { return 3 * (y * 64 + x); };
    CHECK(rgb[at(40, 16)] > 2 * rgb[at(40, 16) + 2]);  // the plate's red, in the plain sky's light
    CHECK(2 * rgb[at(40, 16) + 1] < before[at(40, 16) + 1]);
    CHECK(rgb[at(32, 24) + 2] > 240);  // threads before it
    CHECK(rgb[at(10, 40)] == before[at(10, 40)]);
    CHECK(stage.view.report().memory_bytes > bare.view.report().memory_bytes);
}

TEST_CASE("bodies of patches are drawn where there are any, and the camera has them in the picture",
          "[image]") {
    Stage bare, stage;
    test::Tubes tubes({{0, 5, 0}, {0, -5, 0}}, 6, 8);  // the cross is within 1 m
    tubes.paint(1, 1, {255, 0, 0, 0});
    stage.host.offer<Patches>(tubes);
    for (Stage* each : {&bare, &stage}) {
        each->host.set("thread.color", Vec3{0, 0, 1});
        REQUIRE(each->canvas.attach(each->host));
        REQUIRE(each->view.attach(each->host));
    }
    bare.picture();
    const auto rgb = stage.picture();
    const auto at = [](std::size_t x, std::size_t y) { return 3 * (y * 64 + x); };
    for (const std::size_t y : {5U, 42U}) CHECK(rgb[at(32, y)] > 2 * rgb[at(32, y) + 2]);
    CHECK(rgb[at(32, 14)] < 2 * rgb[at(32, 14) + 2]);
    CHECK(rgb[at(32, 24) + 2] > 150);  // the cross, smaller now
    CHECK(stage.view.report().memory_bytes > bare.view.report().memory_bytes + 64 * 48 * 4 * 8);
}

TEST_CASE("the request's size overrides the scene's", "[unit]") {
    Stage stage;
    stage.host.request_.width = 50;
    stage.host.request_.height = 30;
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE(stage.view.attach(stage.host));
    CHECK(stage.picture().size() == 50 * 30 * 3);
}

TEST_CASE("a hand on the mouse turns the picture, and C turns it back", "[image]") {
    Stage stage;
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE(stage.view.attach(stage.host));
    const auto copy = [&] {
        const auto rgb = stage.picture();
        return std::vector<std::uint8_t>(rgb.begin(), rgb.end());
    };
    const auto first = copy();
    stage.hand.events.orbit_x = 0.2;
    stage.hand.events.zoom = -2;
    const auto turned = copy();
    stage.hand.events = {};
    stage.hand.events.reset_camera = true;
    CHECK(turned != first);
    CHECK(copy() == first);
}

TEST_CASE("a camera inside its own target is a fault at its place in the scene", "[extreme]") {
    Stage stage;
    stage.host.set("camera.position", Vec3{1, 2, 3}, {"s.toml", 4, 1});
    stage.host.set("camera.target", Vec3{1, 2, 3});
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE(stage.view.attach(stage.host));
    REQUIRE(stage.host.faults.size() == 1);
    CHECK(to_string(stage.host.faults[0].where) == "s.toml:4:1");
}

TEST_CASE("a canvas that does not open ends the run in a sentence", "[extreme]") {
    Stage stage;
    stage.host.request_.width = 100000;
    REQUIRE(stage.canvas.attach(stage.host));
    REQUIRE_FALSE(stage.view.attach(stage.host));
    CHECK(stage.view.fault.sentence.find("ask for a smaller --size") != std::string::npos);
}
