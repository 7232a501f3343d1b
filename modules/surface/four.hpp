#pragma once

#include <array>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace orbweaver::surface {

/// Four single-precision numbers at once: plain x86-64 has them, elsewhere a loop gives the same bits.
#if defined(__SSE2__)

struct Four {
    __m128 lanes;

    static Four all(float value) noexcept { return {_mm_set1_ps(value)}; }
    static Four load(const std::array<float, 4>& from) noexcept { return {_mm_load_ps(from.data())}; }
    void store(std::array<float, 4>& to) const noexcept { _mm_storeu_ps(to.data(), lanes); }
    friend Four operator-(const Four& a, const Four& b) noexcept { return {_mm_sub_ps(a.lanes, b.lanes)}; }
    friend Four operator*(const Four& a, const Four& b) noexcept { return {_mm_mul_ps(a.lanes, b.lanes)}; }
    friend Four larger(const Four& a, const Four& b) noexcept { return {_mm_max_ps(a.lanes, b.lanes)}; }
    friend Four smaller(const Four& a, const Four& b) noexcept { return {_mm_min_ps(a.lanes, b.lanes)}; }
    /// Bit i is set where lane i of a is at most lane i of b.
    friend unsigned at_most(const Four& a, const Four& b) noexcept {
        return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a.lanes, b.lanes)));
    }
};

#else

struct Four {
    std::array<float, 4> lanes;

    static Four all(float value) noexcept { return {{value, value, value, value}}; }
    static Four load(const std::array<float, 4>& from) noexcept { return {from}; }
    void store(std::array<float, 4>& to) const noexcept { to = lanes; }
    template <class F>
    static Four each(const Four& a, const Four& b, F&& f) noexcept {
        Four out{};
        for (std::size_t i = 0; i < 4; ++i) out.lanes[i] = f(a.lanes[i], b.lanes[i]);
        return out;
    }
    friend Four operator-(const Four& a, const Four& b) noexcept {
        return each(a, b, [](float x, float y) { return x - y; });
    }
    friend Four operator*(const Four& a, const Four& b) noexcept {
        return each(a, b, [](float x, float y) { return x * y; });
    }
    friend Four larger(const Four& a, const Four& b) noexcept {
        return each(a, b, [](float x, float y) { return x > y ? x : y; });
    }
    friend Four smaller(const Four& a, const Four& b) noexcept {
        return each(a, b, [](float x, float y) { return x < y ? x : y; });
    }
    friend unsigned at_most(const Four& a, const Four& b) noexcept {
        unsigned bits = 0;
        for (unsigned i = 0; i < 4; ++i) bits |= a.lanes[i] <= b.lanes[i] ? 1U << i : 0U;
        return bits;
    }
};

#endif

}  // namespace orbweaver::surface
