#include "picture/png.hpp"

#include <png.h>

#include <memory>
#include <new>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::picture {
namespace {

/// libpng leaves by an exception of ours: it is C, but compiled with unwind tables on every system we build
/// for, and its own longjmp would step over destructors.
[[noreturn]] void fail(png_structp, png_const_charp why) {
    throw Fault(FaultKind::internal, std::string("The PNG encoder failed: ") + why + ".");
}
void ignore_warning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, png_size_t size) {
    auto& out = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    out.insert(out.end(), data, data + size);
}

struct Writer {
    Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore_warning)) {
        if (png == nullptr) throw std::bad_alloc();
        info = png_create_info_struct(png);
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    ~Writer() { png_destroy_write_struct(&png, &info); }

    png_structp png;
    png_infop info = nullptr;
};

void set_effort(png_structp png, PngEffort effort) {
    if (effort == PngEffort::small) {
        png_set_compression_level(png, 9);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
        return;
    }
    // One filter for every row rather than a trial of all five: before a soft sky, `up` took the least time and
    // room.
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
}

}  // namespace

std::vector<std::uint8_t> encode_png(int width, int height, std::span<const std::uint8_t> rgb,
                                     PngEffort effort) {
    const auto row = 3 * static_cast<std::size_t>(width);
    if (width <= 0 || height <= 0 || rgb.size() != row * static_cast<std::size_t>(height))
        throw Fault(FaultKind::internal, "A picture to be written as PNG has " + std::to_string(rgb.size()) +
                                             " bytes, which is not 3 x " + std::to_string(width) + " x " +
                                             std::to_string(height) + ".");
    std::vector<std::uint8_t> out;
    out.reserve(rgb.size() / 2 + 1024);
    Writer writer;
    png_set_write_fn(writer.png, &out, append, nullptr);
    png_set_user_limits(writer.png, 0x7fffffff, 0x7fffffff);
    set_effort(writer.png, effort);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(writer.png, writer.info);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        png_write_row(writer.png, rgb.data() + y * row);
    png_write_end(writer.png, writer.info);
    return out;
}

}  // namespace orbweaver::picture
