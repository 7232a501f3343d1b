#include "sky_source.hpp"

#include <optional>
#include <string>

#include "picture/decode.hpp"

namespace orbweaver::view {
namespace {

std::string face_key(std::size_t face) { return std::string("sky_faces.") + kFaceNames[face]; }

std::optional<picture::LinearPicture> load(Host& host, const std::string& key) {
    try {
        return picture::decode_linear(host.options().text(key));
    } catch (const picture::Unreadable& e) {
        Diagnostic fault = e.diagnostic();
        fault.what = key + ": " + fault.where.file + ": " + fault.what;
        fault.where = host.options().where(key);
        host.report_fault(fault);
        return std::nullopt;
    }
}

bool any_face(const Options& options) {
    for (std::size_t f = 0; f < kFaces; ++f)
        if (options.has(face_key(f))) return true;
    return false;
}

std::string size_of(const picture::LinearPicture& p) {
    return std::to_string(p.width) + " x " + std::to_string(p.height);
}

CubeSky load_faces(Host& host, double exposure) {
    std::array<picture::LinearPicture, kFaces> pictures;
    bool good = true;
    int size = 0;
    for (std::size_t f = 0; f < kFaces; ++f) {
        const auto key = face_key(f);
        if (!host.options().has(key)) {
            host.report_fault(
                {host.options().where(key), key + " is missing", "all six faces of the sky", "name it"});
            good = false;
            continue;
        }
        auto picture = load(host, key);
        if (!picture) {
            good = false;
            continue;
        }
        if (size == 0) size = picture->width;
        if (picture->width != size || picture->height != size) {
            host.report_fault(
                {host.options().where(key), key + " has " + size_of(*picture) + " pixels",
                 "square faces of one size, here " + std::to_string(size) + " x " + std::to_string(size),
                 "scale or cut it"});
            good = false;
        }
        pictures[f] = std::move(*picture);
    }
    return good ? cube_from_faces(pictures, exposure) : plain_sky();
}

CubeSky load_equirectangular(Host& host, double exposure) {
    const auto picture = load(host, "sky");
    if (!picture) return plain_sky();
    if (picture->width != 2 * picture->height)
        host.log(LogLevel::warning,
                 host.options().text("sky") + " has " + size_of(*picture) +
                     " pixels; an equirectangular sky is twice as wide as high, so it will look stretched.");
    return cube_from_equirectangular(*picture, exposure);
}

}  // namespace

CubeSky load_sky(Host& host) {
    const Options& options = host.options();
    const double exposure = options.number("exposure");
    if (any_face(options)) {
        if (options.has("sky"))
            host.report_fault({options.where("sky"), "both sky and sky_faces are given", "one of them",
                               "remove the one that is not wanted"});
        return load_faces(host, exposure);
    }
    return options.has("sky") ? load_equirectangular(host, exposure) : plain_sky();
}

}  // namespace orbweaver::view
