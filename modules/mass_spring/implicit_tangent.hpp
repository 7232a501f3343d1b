#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "linear_solver.hpp"
#include "packing.hpp"

namespace orbweaver::mass_spring {

class SpringSystem;

/// W = M + c C + k K of a network, and its solution, for implicit methods (see DynamicSystem).
class ImplicitTangent {
public:
    /// `network` must outlive it; vectors come as `packing` has them.
    ImplicitTangent(const Network& network, const Packing& packing, LinearSolverKind solver);

    /// `system` is of the same network.
    bool prepare(const SpringSystem& system, std::span<const double> x, double c, double k, bool clamped);
    void solve(std::span<const double> r, std::span<double> u);
    std::size_t memory_bytes() const noexcept;

    double prepare_seconds() const noexcept;  ///< see SpringSystem::work_seconds()
    double solve_seconds() const noexcept;

private:
    const Network* network_;
    Packing packing_;
    std::unique_ptr<LinearSolver> solver_;
    std::vector<Vec3> x_, right_, left_;
    std::vector<double> diagonal_;
    std::vector<SymmetricBlock> blocks_;
};

}  // namespace orbweaver::mass_spring
