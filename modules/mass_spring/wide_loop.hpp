#pragma once

#include <cstddef>

#include "orbweaver/targets.hpp"

/// No pass of the loop that follows depends on another.
#if defined(__clang__)
#define ORBWEAVER_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#else
#define ORBWEAVER_INDEPENDENT _Pragma("GCC ivdep")
#endif

namespace orbweaver::mass_spring {

/// body(i) for i in [0, count), in vectors as wide as the processor has; the bits are the same. No call may
/// depend on another. For speed `body` captures plain pointers by value and is marked ORBWEAVER_ALWAYS_INLINE.
template <class Body>
void wide_loop(std::size_t count, const Body& body) noexcept {
    run_wide([count, &body]() ORBWEAVER_ALWAYS_INLINE {
        ORBWEAVER_INDEPENDENT
        for (std::size_t i = 0; i < count; ++i) body(i);
    });
}

}  // namespace orbweaver::mass_spring
