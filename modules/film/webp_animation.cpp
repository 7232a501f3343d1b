#include "webp_animation.hpp"

#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <string>

#include "orbweaver/fault.hpp"
#include "output/atomic_file.hpp"

namespace orbweaver::film {
namespace {

constexpr float kQuality = 80;
constexpr int kEffort = 1;  // of 6: a film is made while the run waits

struct Raster {
    Raster() { good = WebPPictureInit(&picture) != 0; }
    Raster(const Raster&) = delete;
    Raster& operator=(const Raster&) = delete;
    ~Raster() { WebPPictureFree(&picture); }
    WebPPicture picture{};
    bool good = false;
};

struct Assembled {
    Assembled() { WebPDataInit(&data); }
    Assembled(const Assembled&) = delete;
    Assembled& operator=(const Assembled&) = delete;
    ~Assembled() { WebPDataClear(&data); }
    WebPData data{};
};

}  // namespace

void WebpAnimation::EncoderDelete::operator()(WebPAnimEncoder* encoder) const noexcept {
    WebPAnimEncoderDelete(encoder);
}

WebpAnimation::WebpAnimation(std::filesystem::path file, const VideoFormat& format)
    : file_(std::move(file)), format_(format) {
    if (format.width > WEBP_MAX_DIMENSION || format.height > WEBP_MAX_DIMENSION)
        throw Fault(FaultKind::limit, "An animated WebP is at most " + std::to_string(WEBP_MAX_DIMENSION) +
                                          " pixels a side; ask for a smaller --size.");
    encoder_.reset(WebPAnimEncoderNew(format.width, format.height, nullptr));
    if (!encoder_) fail("the encoder does not start");
}

WebpAnimation::~WebpAnimation() = default;

void WebpAnimation::fail(const char* why) const {
    throw Fault(FaultKind::internal, "Making the animated WebP " + file_.string() + " failed: " + why + ".");
}

int WebpAnimation::time_ms(std::uint64_t picture) const {
    return static_cast<int>(std::lround(1000 * static_cast<double>(picture) / format_.pictures_per_second));
}

void WebpAnimation::add(std::span<const std::uint8_t> rgb) {
    WebPConfig config;
    if (WebPConfigInit(&config) == 0) fail("the library is not the one it was built for");
    config.quality = kQuality;
    config.method = kEffort;
    Raster raster;
    raster.picture.width = format_.width;
    raster.picture.height = format_.height;
    raster.picture.use_argb = 1;
    if (!raster.good || WebPPictureImportRGB(&raster.picture, rgb.data(), 3 * format_.width) == 0)
        fail("a picture does not fit into memory");
    if (WebPAnimEncoderAdd(encoder_.get(), &raster.picture, time_ms(count_), &config) == 0)
        fail(WebPAnimEncoderGetError(encoder_.get()));
    ++count_;
}

void WebpAnimation::close() {
    if (count_ == 0) return;
    Assembled file;
    if (WebPAnimEncoderAdd(encoder_.get(), nullptr, time_ms(count_), nullptr) == 0 ||
        WebPAnimEncoderAssemble(encoder_.get(), &file.data) == 0)
        fail(WebPAnimEncoderGetError(encoder_.get()));
    AtomicFile whole(file_.string());
    whole.write(file.data.bytes, file.data.size);
    whole.commit();
}

}  // namespace orbweaver::film
