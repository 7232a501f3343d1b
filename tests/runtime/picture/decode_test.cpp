#include "picture/decode.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <string>

#include "picture/color.hpp"
#include "picture/png.hpp"
#include "scratch.hpp"

using namespace orbweaver;
using picture::decode;
using picture::decode_linear;

namespace {

std::string png(int width, int height) {
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(i * 2654435761U >> 24);
    const auto bytes = picture::encode_png(width, height, rgb);
    return {bytes.begin(), bytes.end()};
}

/// A flat Radiance picture: mantissas and the shared exponent as they lie in the file (RGBE, Ward 1991).
std::string hdr(int width, int height, const std::string& rgbe) {
    std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                       std::to_string(width) + "\n";
    for (int i = 0; i < width * height; ++i) text += rgbe;
    return text;
}

/// A gray 8 x 8 baseline JPEG, every byte of it from the standard's own tables.
std::string jpeg() {
    std::string j("\xff\xd8\xff\xdb\x00\x43\x00", 7);
    j.append(64, '\x01');
    j += std::string("\xff\xc0\x00\x0b\x08\x00\x08\x00\x08\x01\x01\x11\x00", 13);
    j += std::string("\xff\xc4\x00\x14\x00\x01", 6) + std::string(15, '\0') + std::string("\x00", 1);
    j += std::string("\xff\xc4\x00\x14\x10\x01", 6) + std::string(15, '\0') + std::string("\x00", 1);
    j += std::string("\xff\xda\x00\x08\x01\x01\x00\x00\x3f\x00", 10);
    return j + std::string("\x3f\xff\xd9", 3);
}

/// Three black pixels in a row, of alpha 0, 128 and 255, as Python's zlib packs them.
std::string see_through_png() {
    constexpr std::array<unsigned char, 81> kBytes = {
        137, 80,  78,  71, 13,  10,  26, 10, 0,  0,   0,  13,  73, 72, 68,  82, 0,  0,  0,   3,  0,
        0,   0,   1,   8,  6,   0,   0,  0,  27, 224, 20, 180, 0,  0,  0,   24, 73, 68, 65,  84, 120,
        1,   1,   13,  0,  242, 255, 0,  0,  0,  0,   0,  0,   0,  0,  128, 0,  0,  0,  255, 3,  140,
        1,   128, 237, 78, 4,   65,  0,  0,  0,  0,   73, 69,  78, 68, 174, 66, 96, 130};
    return {kBytes.begin(), kBytes.end()};
}

std::string with_png_size(std::string bytes, std::uint32_t width, std::uint32_t height) {
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[16 + i] = static_cast<char>(width >> (24 - 8 * i));
        bytes[20 + i] = static_cast<char>(height >> (24 - 8 * i));
    }
    return bytes;
}

std::string refusal(const std::string& path, const picture::Limits& limits = {}) {
    try {
        decode(path, limits);
    } catch (const picture::Unreadable& e) {
        const bool beyond = e.diagnostic().what.find("more than the limit") != std::string::npos;
        CHECK(e.kind() == (beyond ? FaultKind::limit : FaultKind::invalid));
        CHECK(e.diagnostic().where.file == path);
        return e.diagnostic().what;
    }
    return "accepted";
}

}  // namespace

TEST_CASE("a Radiance picture's light is mantissa times 2^(exponent - 136)", "[unit]") {
    const test::Scratch scratch;
    const auto file = scratch.write("a.hdr", hdr(3, 2, "\x80\x40\x20\x83"));  // 2^(131-136) = 1/32
    const auto light = decode_linear(file);
    REQUIRE(light.width == 3);
    REQUIRE(light.height == 2);
    CHECK(light.high_dynamic_range);
    CHECK(light.pixel(2, 1)[0] == 4);
    CHECK(light.pixel(2, 1)[1] == 2);
    CHECK(light.pixel(2, 1)[2] == 1);
    CHECK(decode(file).rgb == std::vector<std::uint8_t>(18, 255));
}

TEST_CASE("a PNG's light is that of its sRGB shades", "[unit]") {
    const test::Scratch scratch;
    const auto file = scratch.write("a.png", png(5, 4));
    const auto shades = decode(file);
    const auto light = decode_linear(file);
    CHECK_FALSE(light.high_dynamic_range);
    for (std::size_t i = 0; i < shades.rgb.size(); ++i)
        CHECK(light.rgb[i] == picture::linear_from_byte()[shades.rgb[i]]);
}

TEST_CASE("grays stay as they are, colors become their luma, and what is transparent shows white paper",
          "[unit]") {
    const test::Scratch scratch;
    std::vector<std::uint8_t> grays(3 * 256);
    for (std::size_t i = 0; i < grays.size(); ++i) grays[i] = static_cast<std::uint8_t>(i / 3);
    const auto ramp = picture::encode_png(256, 1, grays);
    const auto shades =
        picture::decode_gray(scratch.write("ramp.png", std::string(ramp.begin(), ramp.end()))).shades;
    REQUIRE(shades.size() == 256);
    for (std::size_t i = 0; i < 256; ++i) CHECK(shades[i] == i);
    const auto colors = picture::encode_png(3, 1, std::vector<std::uint8_t>{255, 0, 0, 0, 255, 0, 0, 0, 255});
    const auto lumas =
        picture::decode_gray(scratch.write("rgb.png", std::string(colors.begin(), colors.end()))).shades;
    CHECK(lumas == std::vector<std::uint8_t>{54, 182, 19});  // 255 x (0.2126, 0.7152, 0.0722), within 1
    const std::string clear = see_through_png();
    CHECK(picture::decode_gray(scratch.write("alpha.png", clear)).shades ==
          std::vector<std::uint8_t>{255, 127, 0});
}

TEST_CASE("a Radiance picture's gray is its light as sRGB codes it", "[unit]") {
    const test::Scratch scratch;
    const auto gray = picture::decode_gray(scratch.write("a.hdr", hdr(2, 2, "\x80\x80\x80\x80")));  // 1/2
    CHECK(gray.shades == std::vector<std::uint8_t>(4, 188));
}

TEST_CASE("a JPEG is read", "[unit]") {
    const test::Scratch scratch;
    const auto gray = decode(scratch.write("a.jpg", jpeg()));
    CHECK(gray.width == 8);
    CHECK(gray.height == 8);
    CHECK(gray.rgb == std::vector<std::uint8_t>(192, 128));
}

TEST_CASE("pictures that cannot be had are refused in words", "[extreme]") {
    struct Case {
        std::string name;
        std::string bytes;
        std::string what;
    };
    const std::string whole = png(64, 48);
    const std::string light = hdr(16, 16, "\x80\x80\x80\x80");
    const Case cases[] = {
        {"empty.png", "", "the file is empty"},
        {"text.png", "not a picture at all", "the file's first bytes are those of no picture format read here"},
        {"magic.png", whole.substr(0, 8), "the picture ends too early: the file is truncated"},
        {"half.png", whole.substr(0, whole.size() / 2), "the picture ends too early: the file is truncated"},
        {"half.hdr", light.substr(0, light.size() / 2), "the picture ends too early: the file is truncated"},
        {"half.jpg", jpeg().substr(0, 90), "the picture ends too early: the file is truncated"},
        {"tail.jpg", jpeg().substr(0, jpeg().size() - 3), "the picture ends too early: the file is truncated"},
        {"wide.png", with_png_size(whole, 60000, 60000),
         "the picture says it has 60000 x 60000 pixels, more than the limit of 33554432"},
        {"flat.png", with_png_size(whole, 64, 0), "the picture has no pixels"},
        {"giant.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 99999 +X 99999\n",
         "the picture says it has 99999 x 99999 pixels, more than the limit of 33554432"},
    };
    const test::Scratch scratch;
    for (const Case& each : cases) {
        INFO(each.name);
        CHECK(refusal(scratch.write(each.name, each.bytes)) == each.what);
    }
}

TEST_CASE("every truncation and every damaged byte ends in a refusal or a picture", "[extreme]") {
    const test::Scratch scratch;
    for (const std::string& whole : {png(9, 7), jpeg(), hdr(9, 7, "\x80\x80\x80\x80")}) {
        for (std::size_t n = 0; n < whole.size(); n += 3)
            CHECK(refusal(scratch.write("cut", whole.substr(0, n))) != "");
        for (std::size_t n = 0; n < whole.size(); n += 2) {
            std::string damaged = whole;
            damaged[n] = static_cast<char>(damaged[n] ^ 0x55);
            CHECK(refusal(scratch.write("damaged", damaged)) != "");
        }
    }
}

TEST_CASE("what is not a file of reasonable size is refused in words", "[extreme]") {
    const test::Scratch scratch;
    CHECK(refusal(scratch.path("absent.png")) == "there is no such file");
    CHECK(refusal(scratch.path()) == "it is not a regular file");
    CHECK(refusal(scratch.write("a.png", png(64, 48)), {100, 1000}).find("more than the limit of 100") !=
          std::string::npos);
    CHECK(refusal(scratch.write("a.png", png(64, 48)), {1 << 20, 1000}) ==
          "the picture says it has 64 x 48 pixels, more than the limit of 1000");
}
