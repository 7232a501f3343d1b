#include "definite_system.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "orbweaver/random.hpp"

using namespace orbweaver;
using namespace orbweaver::spider;

namespace {

/// The largest |A x - b| over a hundred systems A = M M^T + 0.1.
template <std::size_t n>
double worst_residual() {
    const RandomStream random(3, "systems");
    std::uint64_t count = 0;
    double worst = 0;
    for (int round = 0; round < 100; ++round) {
        double m[n][n], a[n][n], kept[n][n], b[n], x[n];
        for (auto& row : m)
            for (double& each : row) each = random.uniform(count++, -1, 1);
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = b[i] = random.uniform(count++, -1, 1);
            for (std::size_t j = 0; j < n; ++j) {
                a[i][j] = i == j ? 0.1 : 0;
                for (std::size_t k = 0; k < n; ++k) a[i][j] += m[i][k] * m[j][k];
                kept[i][j] = a[i][j];
                if (j > i) a[i][j] = std::nan("");  // the upper half is not looked at
            }
        }
        solve_definite(a, x);
        for (std::size_t i = 0; i < n; ++i) {
            double residual = -b[i];
            for (std::size_t j = 0; j < n; ++j) residual += kept[i][j] * x[j];
            worst = std::max(worst, std::abs(residual));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("the solution of a definite system satisfies it", "[unit]") {
    CHECK(worst_residual<1>() < 1e-15);
    CHECK(worst_residual<3>() < 1e-13);  // rounding times a condition of at most some tens
    CHECK(worst_residual<6>() < 1e-13);
}
