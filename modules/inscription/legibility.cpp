#include "legibility.hpp"

#include <algorithm>
#include <cmath>

#include "ink.hpp"
#include "low_pass.hpp"
#include "otsu.hpp"

namespace orbweaver::inscription {

namespace {

struct Box {
    std::uint32_t left, top, width, height;
};

Box dark_box(const Bitmap& coverage, double grown) {
    std::uint32_t left = coverage.width, top = coverage.height, right = 0, bottom = 0;
    for (std::uint32_t y = 0; y < coverage.height; ++y)
        for (std::uint32_t x = 0; x < coverage.width; ++x) {
            if (coverage.row(y)[x] == 0) continue;
            left = std::min(left, x);
            right = std::max(right, x + 1);
            top = std::min(top, y);
            bottom = std::max(bottom, y + 1);
        }
    if (right == 0) return {0, 0, 0, 0};
    const auto by = static_cast<std::uint32_t>(std::ceil(grown));
    left -= std::min(left, by);
    top -= std::min(top, by);
    right = std::min(right + by, coverage.width);
    bottom = std::min(bottom + by, coverage.height);
    return {left, top, right - left, bottom - top};
}

template <class T>
Raster<float> cut_out(const Raster<T>& from, const Box& box) {
    Raster<float> out(box.width, box.height);
    for (std::uint32_t y = 0; y < box.height; ++y)
        std::copy_n(from.row(box.top + y) + box.left, box.width, out.row(y));
    return out;
}

/// From 0 to 1; all 0 where nothing differs.
void stretch(Shades& shades) {
    const auto [low, high] = std::minmax_element(shades.values.begin(), shades.values.end());
    const float from = *low, range = *high - *low;
    for (float& value : shades.values) value = range > 0 ? (value - from) / range : 0;
}

/// Silk per area in what is dark over that in the rest.
double contrast_of(const Shades& ink, const Shades& coverage) {
    double inside = 0, beside = 0, dark = 0;
    for (std::size_t i = 0; i < ink.values.size(); ++i) {
        const double here = ink.values[i], share = coverage.values[i];
        inside += share * here;
        beside += (1 - share) * here;
        dark += share;
    }
    const double bright = static_cast<double>(ink.values.size()) - dark;
    return dark > 0 && bright > 0 && beside > 0 ? (inside / dark) / (beside / bright) : 1;
}

double iou_of(const Shades& picture, const Shades& coverage) {
    const auto threshold = otsu_threshold(picture);
    if (!threshold) return 0;
    std::size_t both = 0, either = 0;
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        const bool seen = picture.values[i] >= *threshold, asked = coverage.values[i] > 0;
        both += seen && asked ? 1 : 0;
        either += seen || asked ? 1 : 0;
    }
    return either > 0 ? static_cast<double>(both) / static_cast<double>(either) : 0;
}

Shades product(const Shades& a, const Shades& b) {
    Shades out(a.width, a.height);
    for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] = a.values[i] * b.values[i];
    return out;
}

double ssim_of(const Shades& a, const Shades& b, double window) {
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
    return sum / static_cast<double>(a.values.size());
}

}  // namespace

Legibility measure_legibility(std::span<const Vec3> points, std::span<const ThreadSegment> segments,
                              const Lettering& lettering) {
    const double blur = lettering.blur / lettering.page.pixel;
    const Box box = dark_box(lettering.coverage, blur);
    if (box.width == 0) return {};
    // What lies beyond the box shows in it, blurred.
    const Shades all = ink(points, segments, lettering.page);
    Legibility found;
    const Shades asked = cut_out(lettering.coverage, box);
    found.contrast = contrast_of(cut_out(all, box), asked);
    Shades picture = cut_out(low_pass(all, blur), box);
    if (found.contrast < 1)
        for (float& value : picture.values) value = -value;
    stretch(picture);
    found.iou = iou_of(picture, asked);
    Shades wanted = cut_out(low_pass(cut_out(lettering.coverage, {0, 0, all.width, all.height}), blur), box);
    stretch(wanted);
    found.ssim = ssim_of(picture, wanted, blur);
    return found;
}

}  // namespace orbweaver::inscription
