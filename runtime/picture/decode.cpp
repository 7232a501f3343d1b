#include "picture/decode.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include "picture/color.hpp"
#include "picture/picture_bytes.hpp"
#include "picture/stb_config.hpp"

namespace orbweaver::picture {
namespace {

/// Feeds the decoder and notices when it asks for more than there is: it would go on with zeros.
struct Reader {
    const std::vector<std::uint8_t>& bytes;
    std::size_t at = 0;
    bool starved = false;

    static int read(void* self, char* to, int size) {
        auto& r = *static_cast<Reader*>(self);
        const auto n = std::min(static_cast<std::size_t>(size), r.bytes.size() - r.at);
        std::memcpy(to, r.bytes.data() + r.at, n);
        r.at += n;
        r.starved = r.starved || n == 0;
        return static_cast<int>(n);
    }
    static void skip(void* self, int n) {
        auto& r = *static_cast<Reader*>(self);
        const auto left = r.bytes.size() - r.at;
        r.starved = r.starved || (n > 0 && static_cast<std::size_t>(n) > left);
        if (n < 0) {
            r.at -= std::min(r.at, static_cast<std::size_t>(-static_cast<long>(n)));
        } else {
            r.at += std::min(static_cast<std::size_t>(n), left);
        }
    }
    static int eof(void* self) {
        const auto& r = *static_cast<Reader*>(self);
        return r.at >= r.bytes.size() ? 1 : 0;
    }
};
constexpr stbi_io_callbacks kReaderCalls{&Reader::read, &Reader::skip, &Reader::eof};

struct StbFree {
    void operator()(void* block) const noexcept { stbi_image_free(block); }
};
template <class T>
using StbBlock = std::unique_ptr<T[], StbFree>;

struct Size {
    int width = 0;
    int height = 0;
    std::size_t pixels() const noexcept {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    std::size_t values() const noexcept { return 3 * pixels(); }
};

[[noreturn]] void refuse(const PictureBytes& file, const std::string& what, const std::string& remedy,
                         FaultKind kind = FaultKind::invalid) {
    Diagnostic fault;
    fault.where.file = file.path;
    fault.what = what;
    fault.expected = std::string("a whole ") + name(file.format) + " picture";
    fault.remedy = remedy;
    throw Unreadable(fault, kind);
}

[[noreturn]] void refuse_damaged(const PictureBytes& file, bool starved) {
    const char* reason = stbi_failure_reason();
    const bool out_of_data = reason != nullptr && std::strcmp(reason, "outofdata") == 0;
    if (starved || out_of_data)
        refuse(file, "the picture ends too early: the file is truncated", "fetch or make it again");
    refuse(file,
           std::string("the picture is damaged (") + (reason != nullptr ? reason : "no reason given") + ")",
           "fetch or make it again");
}

void check_size(const PictureBytes& file, std::size_t width, std::size_t height, const Limits& limits) {
    if (width == 0 || height == 0) refuse(file, "the picture has no pixels", "make it again");
    if (width > limits.pixels / height)
        refuse(file,
               "the picture says it has " + std::to_string(width) + " x " + std::to_string(height) +
                   " pixels, more than the limit of " + std::to_string(limits.pixels),
               "scale it down", FaultKind::limit);
}

/// A PNG's size lies at a fixed place; the decoder would call a giant one an unknown type.
void check_png_header(const PictureBytes& file, const Limits& limits) {
    constexpr std::size_t kWidthAt = 16;
    constexpr std::size_t kHeightAt = 20;
    if (file.bytes.size() < kHeightAt + 4) return;
    const auto number = [&](std::size_t at) {
        std::size_t n = 0;
        for (std::size_t i = 0; i < 4; ++i) n = n << 8 | file.bytes[at + i];
        return n;
    };
    check_size(file, number(kWidthAt), number(kHeightAt), limits);
}

Size read_size(const PictureBytes& file, const Limits& limits) {
    if (file.format == Format::png) check_png_header(file, limits);
    Reader reader{file.bytes};
    Size size;
    int channels = 0;
    if (stbi_info_from_callbacks(&kReaderCalls, &reader, &size.width, &size.height, &channels) == 0)
        refuse_damaged(file, reader.starved);
    check_size(file, static_cast<std::size_t>(std::max(size.width, 0)),
               static_cast<std::size_t>(std::max(size.height, 0)), limits);
    return size;
}

template <class T, class Load>
StbBlock<T> load(const PictureBytes& file, const Size& expected, Load call, int channels = 3) {
    Reader reader{file.bytes};
    Size size;
    int found = 0;
    StbBlock<T> block(call(&kReaderCalls, &reader, &size.width, &size.height, &found, channels));
    if (!block || reader.starved) refuse_damaged(file, reader.starved);
    if (size.width != expected.width || size.height != expected.height)
        refuse(file, "the picture contradicts its own header", "fetch or make it again");
    return block;
}

/// Weights of Rec. 709 in parts of 256: white stays white.
std::uint8_t luma(unsigned r, unsigned g, unsigned b) {
    return static_cast<std::uint8_t>((54 * r + 183 * g + 19 * b + 128) / 256);
}

unsigned on_white(unsigned shade, unsigned alpha) { return (shade * alpha + 255 * (255 - alpha) + 127) / 255; }

}  // namespace

Picture decode(const std::string& path, const Limits& limits) {
    const auto file = read_picture_bytes(path, limits);
    const auto size = read_size(file, limits);
    Picture picture{size.width, size.height, std::vector<std::uint8_t>(size.values())};
    if (file.format == Format::hdr) {
        const auto light = load<float>(file, size, stbi_loadf_from_callbacks);
        std::transform(light.get(), light.get() + size.values(), picture.rgb.begin(), byte_from_linear);
    } else {
        const auto shades = load<std::uint8_t>(file, size, stbi_load_from_callbacks);
        std::copy_n(shades.get(), size.values(), picture.rgb.begin());
    }
    return picture;
}

GrayPicture decode_gray(const std::string& path, const Limits& limits) {
    const auto file = read_picture_bytes(path, limits);
    const auto size = read_size(file, limits);
    GrayPicture picture{size.width, size.height, std::vector<std::uint8_t>(size.pixels())};
    if (file.format == Format::hdr) {
        const auto light = load<float>(file, size, stbi_loadf_from_callbacks);
        for (std::size_t i = 0; i < size.pixels(); ++i)
            picture.shades[i] = luma(byte_from_linear(light[3 * i]), byte_from_linear(light[3 * i + 1]),
                                     byte_from_linear(light[3 * i + 2]));
    } else {
        const auto shades = load<std::uint8_t>(file, size, stbi_load_from_callbacks, 4);
        for (std::size_t i = 0; i < size.pixels(); ++i) {
            const std::uint8_t* p = &shades[4 * i];
            picture.shades[i] = luma(on_white(p[0], p[3]), on_white(p[1], p[3]), on_white(p[2], p[3]));
        }
    }
    return picture;
}

LinearPicture decode_linear(const std::string& path, const Limits& limits) {
    const auto file = read_picture_bytes(path, limits);
    const auto size = read_size(file, limits);
    LinearPicture picture{size.width, size.height, file.format == Format::hdr,
                          std::vector<float>(size.values())};
    if (picture.high_dynamic_range) {
        const auto light = load<float>(file, size, stbi_loadf_from_callbacks);
        std::copy_n(light.get(), size.values(), picture.rgb.begin());
    } else {
        const auto shades = load<std::uint8_t>(file, size, stbi_load_from_callbacks);
        const auto table = linear_from_byte();
        std::transform(shades.get(), shades.get() + size.values(), picture.rgb.begin(),
                       [&](std::uint8_t shade) { return table[shade]; });
    }
    return picture;
}

}  // namespace orbweaver::picture
