#pragma once

#include <cstddef>

#include "real.hpp"

namespace orbweaver::spider {

/// Solves A x = b in place of b, A symmetric and positive definite, of which the lower half is read and
/// overwritten: L D L^T (Cholesky without roots), one division a row.
template <std::size_t n, class Real>
ORBWEAVER_INLINE void solve_definite(Real (&a)[n][n], Real (&b)[n]) noexcept {
    Real per_pivot[n];
    for (std::size_t j = 0; j < n; ++j) {
        per_pivot[j] = 1 / a[j][j];
        for (std::size_t i = j + 1; i < n; ++i) {
            const Real factor = a[i][j] * per_pivot[j];
            for (std::size_t k = i; k < n; ++k) a[k][i] -= a[k][j] * factor;
            b[i] -= b[j] * factor;
        }
    }
    for (std::size_t i = n; i-- > 0;) {
        b[i] *= per_pivot[i];
        for (std::size_t k = 0; k < i; ++k) b[k] -= a[i][k] * b[i];
    }
}

}  // namespace orbweaver::spider
