#pragma once

#include <span>
#include <vector>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// The equation that every stage of a diagonally implicit method solves,
///     v = v_base + g a(x, v),    x = x_base + g v,
/// by Newton's method: (M + g C + g^2 K) dv = M [v_base + g a(x, v) - v].
class NewtonStage {
public:
    explicit NewtonStage(std::size_t length) : a_(length), residual_(length), change_(length) {}

    /// To 1e-10 of the largest velocity, or to rounding. The matrix is made where the stage would end without
    /// forces, unless one for the same g is there from before, and made anew where that does not serve. False
    /// where Newton's method does not converge.
    bool solve(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base, double g,
               std::span<double> x, std::span<double> v);
    /// One iteration from v = 0, with the matrix made there.
    void solve_linearly(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                        double g, std::span<double> x, std::span<double> v);
    /// The next stage makes its own matrix.
    void forget() noexcept { made_for_ = 0; }

    std::size_t memory_bytes() const noexcept { return 3 * a_.capacity() * sizeof(double); }

private:
    bool iterate(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                 double g, std::span<double> x, std::span<double> v);
    /// The largest change that a Newton step made to v.
    double improve(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                   double g, std::span<double> x, std::span<double> v);

    std::vector<double> a_, residual_, change_;
    double made_for_ = 0;  ///< g of the matrix there is; 0: none
};

}  // namespace orbweaver::mass_spring
