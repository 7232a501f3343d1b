#pragma once

/// Code for several instruction sets from one source: what is always inlined takes the instructions of the
/// function that it ends up in.
#define ORBWEAVER_ALWAYS_INLINE __attribute__((always_inline))
#define ORBWEAVER_INLINE inline ORBWEAVER_ALWAYS_INLINE

#if defined(__x86_64__)
// Without FMA: a fused multiply-add rounds once where two instructions round twice, and the bits would
// depend on the machine.
#define ORBWEAVER_AVX2 __attribute__((target("avx2")))
// Twice the registers, even where they are filled by half. It brings FMA with it: compile with
// -ffp-contract=off.
#define ORBWEAVER_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))
// For what no result rests on, as the boxes that a ray may meet: fused where it says so itself.
#define ORBWEAVER_AVX2_FMA __attribute__((target("avx2,fma")))
#else
#define ORBWEAVER_AVX2
#define ORBWEAVER_AVX512
#define ORBWEAVER_AVX2_FMA
#endif

namespace orbweaver {

/// Whether more may be used than any processor of its kind has: unless the environment held ORBWEAVER_PLAIN
/// when it was first asked. The bits are the same; who doubts it can compare.
bool wide_vectors_allowed() noexcept;

inline bool has_avx2() noexcept {
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx2") != 0 && wide_vectors_allowed();
#else
    return false;
#endif
}

inline bool has_avx512() noexcept {
#if defined(__x86_64__)
    return has_avx2() && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
           __builtin_cpu_supports("avx512vl") != 0;
#else
    return false;
#endif
}

inline bool has_avx2_and_fma() noexcept {
#if defined(__x86_64__)
    return has_avx2() && __builtin_cpu_supports("fma") != 0;
#else
    return false;
#endif
}

template <class Body>
ORBWEAVER_AVX2 auto run_avx2(const Body& body) {
    return body();
}

template <class Body>
ORBWEAVER_AVX512 auto run_avx512(const Body& body) {
    return body();
}

/// body(), in registers as wide and as many as the processor has; it is marked ORBWEAVER_ALWAYS_INLINE, and so
/// is what it calls.
template <class Body>
auto run_wide(const Body& body) {
    if (has_avx512()) return run_avx512(body);
    return has_avx2() ? run_avx2(body) : body();
}

}  // namespace orbweaver
