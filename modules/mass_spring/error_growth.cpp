#include "error_growth.hpp"

#include <algorithm>
#include <cstdint>

namespace orbweaver::mass_spring {
namespace {

constexpr double kEndless = 1e30;

double largest(std::span<const double> values) noexcept {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// base^floor(exponent) by products alone: the bits are the same everywhere.
double power(double base, double exponent) noexcept {
    double result = 1;
    for (auto n = static_cast<std::uint64_t>(exponent); n > 0; n /= 2, base *= base)
        if (n % 2 == 1) result *= base;
    return result;
}

}  // namespace

ErrorGrowth::ErrorGrowth(std::span<const double> parted, double left) : parted_(parted), left_(left) {
    constexpr double kParting = 3;  // where they stay together, one half's oscillations resemble the other's
    const std::size_t half = parted.size() / 2;
    const double before = std::max(1.0, largest(parted.first(half)));
    const double ratio = largest(parted.subspan(half)) / before;
    if (half > 0 && ratio > kParting) faster_ = ratio;
}

double ErrorGrowth::damped(double frames) const {
    constexpr double kAllBut = 1e-6;
    const double lost = 1 - left_;
    if (frames * lost < kAllBut) return frames;
    return (1 - power(left_, frames)) / lost;
}

double ErrorGrowth::lasting(double frames) const {
    constexpr double kNothing = 1e-30;
    const std::size_t half = parted_.size() / 2;
    const double seen = std::min(frames, static_cast<double>(parted_.size()));
    double sum = 0, each = 1, level = 1;
    for (std::size_t j = 0; static_cast<double>(j) < seen; ++j, each *= left_) {
        sum += std::max(each, parted_[j]);
        if (j >= half && each > kNothing) level = std::max(level, parted_[j] / each);
    }
    if (faster_ == 1) return sum + level * (damped(frames) - damped(seen));
    const double span = std::max(1.0, static_cast<double>(half));
    double block = span * largest(parted_.subspan(half));
    for (double left = frames - seen; left > 0 && sum < kEndless; left -= span) {
        block *= faster_;
        sum += block * std::min(1.0, left / span);
    }
    return sum;
}

double ErrorGrowth::from(double tried, double frames) const {
    return std::max(1.0, lasting(frames) / lasting(std::min(tried, frames)));
}

double ErrorGrowth::damped_from(double tried, double frames) const {
    return std::max(1.0, damped(frames) / damped(std::min(tried, frames)));
}

bool ErrorGrowth::is_chaotic(double frames) const {
    constexpr double kHopeless = 1e6;  // no halving of steps gains as much
    return lasting(frames) > kHopeless * damped(frames);
}

}  // namespace orbweaver::mass_spring
