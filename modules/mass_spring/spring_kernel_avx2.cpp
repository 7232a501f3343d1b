#include "spring_kernel.hpp"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#include <algorithm>

// AVX2 without FMA: a fused multiply-add rounds once where the plain kernel rounds twice.
#define ORBWEAVER_AVX2 __attribute__((target("avx2")))

namespace orbweaver::mass_spring {
namespace {

static_assert(sizeof(PaddedVec3) == sizeof(__m256d));

/// Three doubles, and the one behind them: not for the last of an array.
ORBWEAVER_AVX2 inline __m256d load(const Vec3& v) noexcept { return _mm256_loadu_pd(&v.x); }

ORBWEAVER_AVX2 inline void store(Vec3& v, __m256d value) noexcept {
    _mm_storeu_pd(&v.x, _mm256_castpd256_pd128(value));
    _mm_store_sd(&v.z, _mm256_extractf128_pd(value, 1));
}

/// A spring's force on its end b, then on its end a. A change of sign is exact.
ORBWEAVER_AVX2 inline void store_pair(PaddedVec3* pair, __m256d pull) noexcept {
    _mm256_store_pd(&pair[0].x, pull);
    _mm256_store_pd(&pair[1].x, _mm256_xor_pd(pull, _mm256_set1_pd(-0.0)));
}

/// Four vectors' sums (x + y) + z.
ORBWEAVER_AVX2 inline __m256d sums(const __m256d (&q)[4]) noexcept {
    const __m256d xz01 = _mm256_unpacklo_pd(q[0], q[1]);
    const __m256d xz23 = _mm256_unpacklo_pd(q[2], q[3]);
    const __m256d xy01 = _mm256_add_pd(xz01, _mm256_unpackhi_pd(q[0], q[1]));
    const __m256d xy23 = _mm256_add_pd(xz23, _mm256_unpackhi_pd(q[2], q[3]));
    return _mm256_add_pd(_mm256_permute2f128_pd(xy01, xy23, 0x20), _mm256_permute2f128_pd(xz01, xz23, 0x31));
}

/// The pulls of springs [i, i + 4). See pull_factor() for the arithmetic, which is the same.
template <bool damped>
ORBWEAVER_AVX2 inline void four_pulls(const SpringTable& table, const KernelInput& input, std::size_t i,
                                      PaddedVec3* pull) noexcept {
    const std::uint32_t* a = &table.a[i];
    const std::uint32_t* b = &table.b[i];
    __m256d l[4];
    __m256d q[4];
    for (int j = 0; j < 4; ++j) {
        l[j] = _mm256_sub_pd(load(input.x[a[j]]), load(input.x[b[j]]));
        q[j] = _mm256_mul_pd(l[j], l[j]);
    }
    const __m256d length = _mm256_sqrt_pd(sums(q));
    const __m256d some = _mm256_cmp_pd(length, _mm256_setzero_pd(), _CMP_GT_OQ);
    const __m256d inverse = _mm256_and_pd(_mm256_div_pd(_mm256_set1_pd(1), length), some);
    __m256d force = _mm256_mul_pd(_mm256_loadu_pd(&table.stiffness[i]),
                                  _mm256_sub_pd(length, _mm256_loadu_pd(&table.rest_length[i])));
    if constexpr (damped) {
        for (int j = 0; j < 4; ++j) {
            q[j] = _mm256_mul_pd(l[j], _mm256_sub_pd(load(input.v[a[j]]), load(input.v[b[j]])));
        }
        const __m256d damping = _mm256_mul_pd(_mm256_loadu_pd(&table.damping[i]), sums(q));
        force = _mm256_add_pd(force, _mm256_mul_pd(damping, inverse));
    }
    const __m256d factor = _mm256_mul_pd(force, inverse);
    const __m256d even = _mm256_unpacklo_pd(factor, factor);
    const __m256d odd = _mm256_unpackhi_pd(factor, factor);
    store_pair(pull + 2 * i, _mm256_mul_pd(l[0], _mm256_permute2f128_pd(even, even, 0x00)));
    store_pair(pull + 2 * i + 2, _mm256_mul_pd(l[1], _mm256_permute2f128_pd(odd, odd, 0x00)));
    store_pair(pull + 2 * i + 4, _mm256_mul_pd(l[2], _mm256_permute2f128_pd(even, even, 0x11)));
    store_pair(pull + 2 * i + 6, _mm256_mul_pd(l[3], _mm256_permute2f128_pd(odd, odd, 0x11)));
}

/// Whether any of four springs ends at the last particle, behind which there is nothing to read.
ORBWEAVER_AVX2 inline bool touches_last(const SpringTable& table, std::size_t i) noexcept {
    const __m128i last = _mm_set1_epi32(static_cast<int>(table.particles() - 1));
    const __m128i a = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&table.a[i]));
    const __m128i b = _mm_loadu_si128(reinterpret_cast<const __m128i*>(&table.b[i]));
    return _mm_movemask_epi8(_mm_or_si128(_mm_cmpeq_epi32(a, last), _mm_cmpeq_epi32(b, last))) != 0;
}

template <bool damped>
ORBWEAVER_AVX2 void pulls_by_four(const SpringTable& table, const KernelInput& input, std::size_t begin,
                                  std::size_t end, PaddedVec3* pull) noexcept {
    std::size_t i = begin;
    for (; i + 4 <= end; i += 4) {
        if (touches_last(table, i)) {
            plain_kernels().pulls(table, input, i, i + 4, pull);
        } else {
            four_pulls<damped>(table, input, i, pull);
        }
    }
    plain_kernels().pulls(table, input, i, end, pull);
}

void avx2_pulls(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                PaddedVec3* pull) noexcept {
    (table.damped ? pulls_by_four<true> : pulls_by_four<false>)(table, input, begin, end, pull);
}

ORBWEAVER_AVX2 void avx2_accelerations(const SpringTable& table, const KernelInput& input,
                                       const PaddedVec3* pull, std::size_t begin, std::size_t end,
                                       Vec3* a) noexcept {
    const __m256d gravity = _mm256_setr_pd(input.gravity.x, input.gravity.y, input.gravity.z, 0);
    const __m256d drag = _mm256_set1_pd(input.drag);
    const std::uint32_t* entries = table.incident.data();
    const std::size_t wide_end = std::min(end, table.particles() - 1);
    for (std::size_t i = begin; i < wide_end; ++i) {
        if (table.inverse_mass[i] == 0) {
            a[i] = {};
            continue;
        }
        __m256d sum = _mm256_setzero_pd();
        for (std::uint32_t e = table.first[i]; e < table.first[i + 1]; e += SpringTable::kGroup) {
            for (std::uint32_t j = 0; j < SpringTable::kGroup; ++j)
                sum = _mm256_add_pd(sum, _mm256_load_pd(&pull[entries[e + j]].x));
        }
        if (input.external != nullptr) sum = _mm256_add_pd(sum, load(input.external[i]));
        sum = _mm256_sub_pd(sum, _mm256_mul_pd(drag, load(input.v[i])));
        sum = _mm256_mul_pd(sum, _mm256_broadcast_sd(&table.inverse_mass[i]));
        store(a[i], _mm256_add_pd(sum, gravity));
    }
    plain_kernels().accelerations(table, input, pull, std::max(begin, wide_end), end, a);
}

}  // namespace

const SpringKernels* avx2_kernels() noexcept {
    static constexpr SpringKernels kernels{avx2_pulls, avx2_accelerations};
    return __builtin_cpu_supports("avx2") != 0 ? &kernels : nullptr;
}

}  // namespace orbweaver::mass_spring

#else

namespace orbweaver::mass_spring {
const SpringKernels* avx2_kernels() noexcept { return nullptr; }
}  // namespace orbweaver::mass_spring

#endif
