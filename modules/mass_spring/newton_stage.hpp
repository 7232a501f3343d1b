#pragma once

#include <span>
#include <vector>

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

/// The equation that every stage of a diagonally implicit method solves,
///     v = v_base + g a(x, v),    x = x_base + g v,
/// by Newton's method: (M + g C + g^2 K) dv = M r with the residual r = v_base + g a(x, v) - v.
///
/// -M r is the gradient of the incremental potential, kinetic energy of v - v_base plus the springs' energy at
/// x plus what is dissipated on the way, so a step is shortened until it does not climb on the other side of
/// the valley (|dv M r| falls): what bends far within a step is found all the same.
class NewtonStage {
public:
    explicit NewtonStage(std::size_t length) : residual_(length), change_(length), trial_(length) {}

    /// From the guess in v, to 1e-8 of the largest velocity, or to rounding. A matrix for the same g is kept
    /// while it serves. False where Newton's method does not converge within what allow() left.
    bool solve(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base, double g,
               std::span<double> x, std::span<double> v);
    /// One iteration from v = 0, with the clamped matrix made there. False where it is not positive definite.
    bool solve_linearly(DynamicSystem& system, std::span<const double> x_base, std::span<const double> v_base,
                        double g, std::span<double> x, std::span<double> v);
    /// Iterations that all stages from now on may take together; then none is found any more.
    void allow(int iterations) noexcept { iterations_left_ = iterations; }
    /// The next stage makes its own matrix.
    void forget() noexcept { made_for_ = 0; }

    std::size_t memory_bytes() const noexcept { return 3 * trial_.capacity() * sizeof(double); }

private:
    struct Stage {
        DynamicSystem& system;
        std::span<const double> x_base, v_base;
        double g;
        std::span<double> x, v;
    };

    /// x and residual_ of v.
    void look(const Stage& stage, std::span<const double> v);
    bool make_matrix(const Stage& stage, Tangent tangent);
    /// change_, by the matrix there is or a new one. False where there is none.
    bool find_change(const Stage& stage);
    /// v moves along change_, as far as is of use; how far, 1 for all the way, 0 for nowhere.
    double search_line(const Stage& stage);

    /// v moves all the way along change_.
    void take_change(const Stage& stage);

    std::vector<double> residual_, change_, trial_;
    double made_for_ = 0;  ///< g of the matrix there is; 0: none
    Tangent made_of_ = Tangent::exact;
    int iterations_left_ = 0;
};

}  // namespace orbweaver::mass_spring
