#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace orbweaver::crawler {

/// What muscles make of a segment.
struct Flex {
    double strain = 0;  ///< longer by this share
    double side = 0;    ///< 1/m, bent to the left
    double up = 0;      ///< 1/m, bent upwards
};

/// How strongly muscles work, as a wave or along the whole body alike.
struct Effort {
    double strain = 0;  ///< amplitude of the wave of strain, 1
    double bend = 0;    ///< of the curvature to the sides, 1/m
    double lift = 0;    ///< of the curvature upwards, 1/m
    double turn = 0;    ///< 1/m, to the left, everywhere
};

enum class WaveForm : std::uint8_t { sine, square };

/// A wave along the body: every channel is its effort times the wave, some degrees later.
struct Gait {
    std::string_view name;
    std::string_view meaning;
    int way = 1;            ///< 1: waves run from head to tail; -1: from tail to head
    bool strains = false;   ///< has a wave of strain
    bool bends = false;     ///< of curvature to the sides
    bool lifts = false;     ///< of curvature upwards; who is lifted holds on to nothing
    double lift_later = 0;  ///< degrees
};

std::span<const Gait> gaits() noexcept;
/// Null where there is none of that name.
const Gait* find_gait(std::string_view name) noexcept;

/// The waves of one gait along bodies of so many segments. With s = 0 at the tail and 1 at the head and
/// `cycles` since the start, a wave is cos(2 pi (waves s + way cycles)), or its sign.
class Waves {
public:
    Waves(const Gait& gait, WaveForm form, double waves, std::uint32_t segments);
    WaveForm form() const noexcept { return form_; }
    /// Of each segment, from the tail on. Bits do not depend on the C library.
    void flex(double cycles, const Effort& effort, std::span<Flex> into) const noexcept;

private:
    double value(double cosine) const noexcept;

    const Gait* gait_;
    WaveForm form_;
    std::vector<double> cosine_, sine_;  ///< of 360 degrees waves s, at the segments' middles
};

}  // namespace orbweaver::crawler
