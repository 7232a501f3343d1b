#include "sky_source.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "fake_host.hpp"
#include "picture/png.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using namespace orbweaver::view;

namespace {

std::string write_png(const test::Scratch& scratch, const std::string& name, int width, int height,
                      std::uint8_t shade = 255) {
    const std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width * height), shade);
    const auto bytes = picture::encode_png(width, height, rgb);
    return scratch.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void set_faces(test::FakeHost& host, const std::string& file) {
    for (const char* face : kFaceNames) host.set(std::string("sky_faces.") + face, file, {"s.toml", 9, 1});
}

}  // namespace

TEST_CASE("one picture or six make the sky; none makes the plain one", "[unit]") {
    const test::Scratch scratch;
    test::FakeHost host;
    host.set("exposure", 1.0);
    CHECK(load_sky(host).faces == plain_sky().faces);
    host.set("sky", write_png(scratch, "sky.png", 96, 48));
    CHECK(load_sky(host).faces[3].front() == 1);

    test::FakeHost six;
    six.set("exposure", 1.0);
    set_faces(six, write_png(scratch, "face.png", 4, 4));
    CHECK(load_sky(six).size == 4);
    CHECK(host.faults.empty());
    CHECK(six.faults.empty());
}

TEST_CASE("an unreadable sky is a fault at the place where the scene names it", "[extreme]") {
    const test::Scratch scratch;
    test::FakeHost host;
    host.set("exposure", 1.0);
    const auto file = scratch.write("sky.png", "words");
    host.set("sky", file, {"s.toml", 7, 3});
    load_sky(host);
    REQUIRE(host.faults.size() == 1);
    CHECK(to_string(host.faults[0].where) == "s.toml:7:3");
    CHECK(host.faults[0].what ==
          "sky: " + file + ": the file's first bytes are those of no picture format read here");
}

TEST_CASE("every fault of six faces is reported at once", "[extreme]") {
    const test::Scratch scratch;
    test::FakeHost host;
    host.set("exposure", 1.0);
    set_faces(host, write_png(scratch, "face.png", 4, 4));
    host.set("sky", write_png(scratch, "sky.png", 8, 4), {"s.toml", 3, 1});
    host.set("sky_faces.left", write_png(scratch, "left.png", 4, 2), {"s.toml", 5, 1});
    host.set("sky_faces.top", scratch.write("top.png", ""), {"s.toml", 6, 1});
    load_sky(host);
    REQUIRE(host.faults.size() == 3);
    CHECK(host.faults[0].what == "both sky and sky_faces are given");
    CHECK(host.faults[1].what == "sky_faces.left has 4 x 2 pixels");
    CHECK(host.faults[2].what.find("the file is empty") != std::string::npos);

    test::FakeHost one;
    one.set("exposure", 1.0);
    one.set("sky_faces.front", write_png(scratch, "face.png", 4, 4));
    load_sky(one);
    CHECK(one.faults.size() == 5);
}

TEST_CASE("a sky that is not twice as wide as high is drawn with a warning", "[unit]") {
    const test::Scratch scratch;
    test::FakeHost host;
    host.set("exposure", 1.0);
    host.set("sky", write_png(scratch, "sky.png", 64, 48));
    load_sky(host);
    CHECK(host.faults.empty());
    REQUIRE(host.logged.size() == 1);
    CHECK(host.logged[0].find("twice as wide as high") != std::string::npos);
}
