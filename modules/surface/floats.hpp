#pragma once

#include <cstdint>
#include <cstring>

#include "orbweaver/lanes.hpp"
#include "orbweaver/targets.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace orbweaver::surface {

/// Single-precision numbers side by side, as many as any x86-64 has in a register. `Floats` and `Mask` are n of
/// them and n answers, all ones for yes.
struct FourWide {
    using Floats = float __attribute__((vector_size(16)));
    using Mask = std::int32_t __attribute__((vector_size(16)));

    /// One value in all places.
    ORBWEAVER_INLINE static void fill(Floats& out, float value) noexcept { out = Floats{} + value; }
    ORBWEAVER_INLINE static void fill(Lanes& out, double value) noexcept { out = in_all(value); }
    /// out = a * by - less, rounded once or twice.
    ORBWEAVER_INLINE static void scale(const Floats& a, const Floats& by, const Floats& less,
                                       Floats& out) noexcept {
        out = a * by - less;
    }
    /// Bit i is the sign of lane i.
    ORBWEAVER_INLINE static unsigned signs(const Lanes& of) noexcept { return sign_bits(of); }
    /// Bit i is answer i.
    ORBWEAVER_INLINE static unsigned bits(const Mask& mask) noexcept {
#if defined(__x86_64__)
        return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
#else
        unsigned bits = 0;
        for (unsigned i = 0; i < 4; ++i) bits |= mask[i] != 0 ? 1U << i : 0U;
        return bits;
#endif
    }
};

#if defined(__x86_64__)

/// As many as AVX has. Not always inlined: that happens in a function for the same instructions, and only
/// there.
struct EightWide {
    using Floats = float __attribute__((vector_size(32)));
    using Mask = std::int32_t __attribute__((vector_size(32)));

    ORBWEAVER_AVX2 static void fill(Floats& out, const float& value) noexcept {
        out = reinterpret_cast<Floats>(_mm256_set1_ps(value));
    }
    ORBWEAVER_AVX2 static void fill(Lanes& out, const double& value) noexcept { out = _mm256_set1_pd(value); }
    ORBWEAVER_AVX2 static unsigned signs(const Lanes& of) noexcept {
        return static_cast<unsigned>(_mm256_movemask_pd(of));
    }
    ORBWEAVER_AVX2_FMA static void scale(const Floats& a, const Floats& by, const Floats& less,
                                         Floats& out) noexcept {
        out = reinterpret_cast<Floats>(_mm256_fmsub_ps(
            reinterpret_cast<__m256>(a), reinterpret_cast<__m256>(by), reinterpret_cast<__m256>(less)));
    }
    ORBWEAVER_AVX2_FMA static unsigned bits(const Mask& mask) noexcept {
        return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
    }
};

#else

using EightWide = FourWide;

#endif

template <class Floats>
ORBWEAVER_INLINE Floats floats_at(const float* from) noexcept {
    Floats floats;
    std::memcpy(&floats, from, sizeof floats);
    return floats;
}
template <class Floats>
ORBWEAVER_INLINE Floats larger(const Floats& a, const Floats& b) noexcept {
    return a > b ? a : b;
}
template <class Floats>
ORBWEAVER_INLINE Floats smaller(const Floats& a, const Floats& b) noexcept {
    return a < b ? a : b;
}

}  // namespace orbweaver::surface
