#include "legibility.hpp"

#include <algorithm>
#include <cmath>

#include "ink.hpp"
#include "low_pass.hpp"
#include "otsu.hpp"

namespace orbweaver::inscription {

namespace {

constexpr double kReach = 4;  ///< deviations, of a Gaussian

Box grown(Box box, double by, std::uint32_t side) {
    const auto more = static_cast<std::uint32_t>(std::ceil(by));
    return {box.left - std::min(box.left, more), box.top - std::min(box.top, more),
            std::min(box.right + more, side), std::min(box.bottom + more, side)};
}

template <class T>
Raster<float> cut_out(const Raster<T>& from, const Box& box) {
    Raster<float> out(box.right - box.left, box.bottom - box.top);
    for (std::uint32_t y = 0; y < out.height; ++y)
        std::copy_n(from.row(box.top + y) + box.left, out.width, out.row(y));
    return out;
}

/// What a box shows once all is blurred: of what lies beside it too.
template <class T>
Shades blurred_within(const Raster<T>& picture, const Box& box, double blur) {
    const auto side = picture.width;
    const Box wide = grown(box, kReach * blur, side);
    const Box within{box.left - wide.left, box.top - wide.top, box.right - wide.left, box.bottom - wide.top};
    return cut_out(low_pass(cut_out(picture, wide), blur), within);
}

/// From 0 to 1; all 0 where nothing differs.
void stretch(Shades& shades) {
    const auto [low, high] = std::minmax_element(shades.values.begin(), shades.values.end());
    const float from = *low, range = *high - *low;
    for (float& value : shades.values) value = range > 0 ? (value - from) / range : 0;
}

/// Sums over all blocks.
struct Account {
    double inside = 0, beside = 0, dark = 0, bright = 0;  ///< silk and pixels
    std::size_t both = 0, either = 0;                     ///< pixels that are dark in both pictures, and in any
    double ssim = 0, pixels = 0;

    void add_silk(const Shades& ink, const Shades& coverage) {
        for (std::size_t i = 0; i < ink.values.size(); ++i) {
            const double here = ink.values[i], share = coverage.values[i];
            inside += share * here;
            beside += (1 - share) * here;
            dark += share;
            bright += 1 - share;
        }
    }
    void add_overlap(const Shades& picture, const Shades& coverage) {
        const double threshold = otsu_threshold(picture).value_or(2);
        for (std::size_t i = 0; i < picture.values.size(); ++i) {
            const bool seen = picture.values[i] >= threshold, asked = coverage.values[i] > 0;
            both += seen && asked ? 1 : 0;
            either += seen || asked ? 1 : 0;
        }
    }
    double contrast() const {
        return dark > 0 && bright > 0 && beside > 0 ? (inside / dark) / (beside / bright) : 1;
    }
};

Shades product(const Shades& a, const Shades& b) {
    Shades out(a.width, a.height);
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = a.values[i] * b.values[i];
    return out;
}

/// Summed over all pixels.
double ssim_sum(const Shades& a, const Shades& b, double window) {
    constexpr double kMeans = 0.01 * 0.01, kVariances = 0.03 * 0.03;
    const Shades mean_a = low_pass(a, window), mean_b = low_pass(b, window);
    const Shades square_a = low_pass(product(a, a), window), square_b = low_pass(product(b, b), window);
    const Shades mixed = low_pass(product(a, b), window);
    double sum = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const double ma = mean_a.values[i], mb = mean_b.values[i];
        const double variances = square_a.values[i] - ma * ma + square_b.values[i] - mb * mb;
        const double covariance = mixed.values[i] - ma * mb;
        sum += (2 * ma * mb + kMeans) * (2 * covariance + kVariances) /
               ((ma * ma + mb * mb + kMeans) * (variances + kVariances));
    }
    return sum;
}

}  // namespace

double Lettering::cut_share() const {
    const auto dark = static_cast<double>(std::count(coverage.values.begin(), coverage.values.end(), 1));
    return cut > 0 ? cut / (cut + dark) : 0;
}

Legibility measure_legibility(std::span<const Vec3> points, std::span<const ThreadSegment> segments,
                              const Lettering& lettering) {
    const double blur = lettering.blur / lettering.page.pixel;
    const std::uint32_t side = lettering.page.side;
    const Shades seen = ink(points, segments, lettering.page);
    std::vector<Box> boxes;
    Account account;
    for (const Box& block : lettering.blocks) {
        boxes.push_back(grown(block, blur, side));
        account.add_silk(cut_out(seen, boxes.back()), cut_out(lettering.coverage, boxes.back()));
    }
    const float sign = account.contrast() < 1 ? -1 : 1;
    for (const Box& box : boxes) {
        Shades picture = blurred_within(seen, box, blur),
               wanted = blurred_within(lettering.coverage, box, blur);
        for (float& value : picture.values) value *= sign;
        stretch(picture);
        stretch(wanted);
        account.add_overlap(picture, cut_out(lettering.coverage, box));
        account.ssim += ssim_sum(picture, wanted, blur);
        account.pixels += static_cast<double>(picture.values.size());
    }
    if (account.pixels == 0) return {};
    const double either = static_cast<double>(account.either) + lettering.cut;
    return {either > 0 ? static_cast<double>(account.both) / either : 0, account.ssim / account.pixels,
            account.contrast()};
}

}  // namespace orbweaver::inscription
