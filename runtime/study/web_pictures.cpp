#include "study/web_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "orbweaver/contracts/picture_source.hpp"
#include "orbweaver/fault.hpp"
#include "orbweaver/gaussian_blur.hpp"
#include "run/session.hpp"
#include "study/subject.hpp"

namespace orbweaver::study {

namespace {

constexpr double kFieldOfView = 20;  ///< degrees: a long lens, which sees a web that sways much as one at rest
constexpr double kHalfTangent = 0.17632698070846498;  ///< tan(kFieldOfView / 2)
constexpr int kLargestSide = 8192;                    ///< pixels, of a view
constexpr double kPixelsPerBlur = 2;

/// The square that holds all blocks, as a camera sees it.
struct Scenery {
    Vec3 middle, right, up;  ///< m; unit
    double side = 0;         ///< m

    Vec3 normal() const { return cross(right, up); }
};

Scenery scenery_of(const Photograph& how) {
    const WritingWays::Block& first = how.blocks.front();
    Scenery scenery{first.middle, first.right / norm(first.right), first.up / norm(first.up), 0};
    double left = 0, far_right = 0, low = 0, high = 0;
    for (const auto& block : how.blocks) {
        const Vec3 from = block.middle - first.middle;
        const double x = dot(from, scenery.right), y = dot(from, scenery.up);
        const double half_width = norm(block.right), half_height = norm(block.up);
        left = std::min(left, x - half_width);
        far_right = std::max(far_right, x + half_width);
        low = std::min(low, y - half_height);
        high = std::max(high, y + half_height);
    }
    scenery.middle += 0.5 * (left + far_right) * scenery.right + 0.5 * (low + high) * scenery.up;
    scenery.side = std::max(far_right - left, high - low) + 4 * how.margin;
    return scenery;
}

std::string vector_text(const Vec3& v) { return fmt::format("[{}, {}, {}]", v.x, v.y, v.z); }

/// A camera before the web, such that the picture shows the scenery.
void place_camera(const Scenery& scenery, int side, RunSettings& run) {
    const double distance = 0.5 * scenery.side / kHalfTangent;
    run.request.pictures = true;
    run.request.width = run.request.height = side;
    run.overrides.push_back("view.camera.position=" +
                            vector_text(scenery.middle + distance * scenery.normal()));
    run.overrides.push_back("view.camera.target=" + vector_text(scenery.middle));
    run.overrides.push_back(fmt::format("view.camera.fov={}", kFieldOfView));
}

/// One block of a picture, silk dark.
class Cutting {
public:
    Cutting(const PictureSource& source, std::span<const std::uint8_t> rgb, const Scenery& scenery,
            const WritingWays::Block& block, double margin) {
        const double scale = source.height() / scenery.side;  // pixels a metre
        const Vec3 from = block.middle - scenery.middle;
        const double x = 0.5 * source.width() + scale * dot(from, scenery.right);
        const double y = 0.5 * source.height() - scale * dot(from, scenery.up);
        const double half_width = scale * (norm(block.right) + margin),
                     half_height = scale * (norm(block.up) + margin);
        const auto pixel = [](double at, int size) {
            return static_cast<std::size_t>(std::clamp(at, 0.0, double(size)));
        };
        const std::size_t left = pixel(x - half_width, source.width()),
                          right = pixel(x + half_width, source.width());
        const std::size_t top = pixel(y - half_height, source.height()),
                          bottom = pixel(y + half_height, source.height());
        width_ = right - left;
        height_ = bottom - top;
        for (std::size_t row = top; row < bottom; ++row)
            for (std::size_t column = left; column < right; ++column) {
                const std::uint8_t* at = &rgb[3 * (row * static_cast<std::size_t>(source.width()) + column)];
                values_.push_back(-(0.2126F * at[0] + 0.7152F * at[1] + 0.0722F * at[2]));
            }
    }

    /// By a Gaussian of so many pixels, of which kPixelsPerBlur are left.
    void blur(double deviation) {
        gaussian_blur(values_, width_, height_, deviation);
        const double step = deviation / kPixelsPerBlur;
        if (step <= 1) return;
        const auto width = static_cast<std::size_t>(static_cast<double>(width_) / step);
        const auto height = static_cast<std::size_t>(static_cast<double>(height_) / step);
        std::vector<float> fewer;
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                fewer.push_back(
                    values_[static_cast<std::size_t>((static_cast<double>(y) + 0.5) * step) * width_ +
                            static_cast<std::size_t>((static_cast<double>(x) + 0.5) * step)]);
        values_ = std::move(fewer);
        width_ = width;
        height_ = height;
    }

    picture::GrayPicture stretched() const {
        picture::GrayPicture picture{static_cast<int>(width_), static_cast<int>(height_), {}};
        const auto [low, high] = std::minmax_element(values_.begin(), values_.end());
        const float range = *high > *low ? *high - *low : 1;
        for (const float value : values_)
            picture.shades.push_back(static_cast<std::uint8_t>(255 * (value - *low) / range));
        return picture;
    }

private:
    std::size_t width_ = 0, height_ = 0;
    std::vector<float> values_;
};

}  // namespace

std::vector<std::vector<BlockPictures>> photograph(RunSettings run, const Photograph& how,
                                                   const std::vector<double>& times,
                                                   const std::function<bool()>& stop_asked) {
    const Scenery scenery = scenery_of(how);
    const double side = std::ceil(scenery.side / how.pixel);
    if (!(side <= kLargestSide))
        throw Fault(
            FaultKind::limit,
            fmt::format("a picture in which the web's meshes can be told from each other would be {:.0f} "
                        "pixels wide; expected at most {}: study a web of fewer turns",
                        side, kLargestSide));
    place_camera(scenery, static_cast<int>(side), run);
    PlannedScene planned = plan_scene(run);
    if (!planned.plan.faults.empty()) throw Fault(FaultKind::invalid, all_sentences(planned.plan.faults));
    Session session(planned.plan, run.request);
    if (!session.faults().empty()) throw Fault(FaultKind::invalid, all_sentences(session.faults()));
    PictureSource* source = session.find<PictureSource>();
    if (source == nullptr)
        throw Fault(FaultKind::internal, "no module draws pictures; install the module view");
    std::vector<std::vector<BlockPictures>> pictures;
    for (const double time : times) {
        while (session.time() < time - 0.5 * session.scene().step)
            if ((stop_asked && stop_asked()) || !session.step(stop_asked))
                throw Fault(FaultKind::stopped, "the scene was not run to its end");
        session.present(false);
        const auto rgb = source->rgb();
        pictures.emplace_back();
        for (const WritingWays::Block& block : how.blocks) {
            Cutting cutting(*source, rgb, scenery, block, how.margin);
            picture::GrayPicture plain = cutting.stretched();
            cutting.blur(how.blur * source->height() / scenery.side);
            pictures.back().push_back({std::move(plain), cutting.stretched()});
        }
    }
    return pictures;
}

}  // namespace orbweaver::study
