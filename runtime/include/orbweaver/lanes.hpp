#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "orbweaver/targets.hpp"

namespace orbweaver {

/// Four doubles at once.
using Lanes = double __attribute__((vector_size(32)));

ORBWEAVER_INLINE Lanes load(const double* from) noexcept {
    Lanes lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

ORBWEAVER_INLINE void store(double* to, const Lanes& lanes) noexcept { std::memcpy(to, &lanes, sizeof lanes); }

ORBWEAVER_INLINE Lanes in_all(double value) noexcept { return Lanes{value, value, value, value}; }

using LaneBits = std::int64_t __attribute__((vector_size(32)));
inline constexpr std::int64_t kLaneSign = std::numeric_limits<std::int64_t>::min();

ORBWEAVER_INLINE Lanes absolute(const Lanes& of) noexcept {
    return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(of) & ~kLaneSign);
}
/// With the other sign where `by` has one.
ORBWEAVER_INLINE Lanes flipped_by(const Lanes& by, const Lanes& of) noexcept {
    return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(of) ^
                                   (reinterpret_cast<LaneBits>(by) & kLaneSign));
}

/// Bit i is the sign of lane i.
ORBWEAVER_INLINE unsigned sign_bits(const Lanes& of) noexcept {
#if defined(__SSE2__)
    const auto low = __builtin_shufflevector(of, of, 0, 1), high = __builtin_shufflevector(of, of, 2, 3);
    return static_cast<unsigned>(_mm_movemask_pd(low) | _mm_movemask_pd(high) << 2);
#else
    unsigned bits = 0;
    for (unsigned i = 0; i < 4; ++i) bits |= std::signbit(of[i]) ? 1U << i : 0U;
    return bits;
#endif
}

}  // namespace orbweaver
