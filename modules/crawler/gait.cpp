#include "gait.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "orbweaver/exact_math.hpp"

namespace orbweaver::crawler {

namespace {

constexpr std::array<Gait, 4> kGaits{{
    {"rectilinear", "segments stretch and shorten one after the other, from head to tail", 1, true, false,
     false, 0},
    {"undulation", "waves of bends to left and right, from head to tail", 1, false, true, false, 0},
    {"sidewinding", "waves of bends to the sides, and a quarter later of bends upwards, from head to tail", 1,
     false, true, true, 90},
    {"caterpillar", "segments that shorten are lifted and carried on, from tail to head", -1, true, false, true,
     0},
}};

/// The cosine of an angle, that of another one being given with its sine, less a shift.
double shifted(double cosine, double sine, double degrees) noexcept {
    return cosine * cos_degrees(degrees) + sine * sin_degrees(degrees);
}

}  // namespace

std::span<const Gait> gaits() noexcept { return kGaits; }

const Gait* find_gait(std::string_view name) noexcept {
    const auto found =
        std::find_if(kGaits.begin(), kGaits.end(), [&](const Gait& g) { return g.name == name; });
    return found == kGaits.end() ? nullptr : &*found;
}

Waves::Waves(const Gait& gait, WaveForm form, double waves, std::uint32_t segments)
    : gait_(&gait), form_(form), cosine_(segments), sine_(segments) {
    for (std::uint32_t i = 0; i < segments; ++i) {
        const double degrees = 360 * waves * (i + 0.5) / segments;
        cosine_[i] = cos_degrees(degrees);
        sine_[i] = sin_degrees(degrees);
    }
}

double Waves::value(double cosine) const noexcept {
    if (form_ == WaveForm::sine) return cosine;
    return cosine < 0 ? -1 : 1;
}

void Waves::flex(double cycles, const Effort& effort, std::span<Flex> into) const noexcept {
    const double degrees = 360 * gait_->way * (cycles - std::floor(cycles));
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    for (std::size_t i = 0; i < into.size(); ++i) {
        const double cosine = cosine_[i] * c - sine_[i] * s, sine = sine_[i] * c + cosine_[i] * s;
        Flex& flex = into[i];
        flex = {0, effort.turn, 0};
        if (gait_->strains) flex.strain = effort.strain * value(cosine);
        if (gait_->bends) flex.side += effort.bend * value(cosine);
        if (gait_->lifts) flex.up = effort.lift * value(shifted(cosine, sine, gait_->lift_later));
    }
}

}  // namespace orbweaver::crawler
