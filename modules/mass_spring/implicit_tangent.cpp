#include "implicit_tangent.hpp"

#include "spring_system.hpp"

namespace orbweaver::mass_spring {

ImplicitTangent::ImplicitTangent(const Network& network, const Packing& packing, LinearSolverKind solver)
    : network_(&network),
      packing_(packing),
      solver_(make_linear_solver(solver, network)),
      x_(network.size()),
      right_(network.size()),
      left_(network.size()),
      diagonal_(network.size()),
      blocks_(network.springs.size()) {}

bool ImplicitTangent::prepare(const SpringSystem& system, std::span<const double> x, double c, double k,
                              bool clamped) {
    packing_.unpack(x, x_);
    for (std::size_t i = 0; i < x_.size(); ++i) diagonal_[i] = network_->mass[i] + c * system.drag();
    for (std::size_t i = 0; i < blocks_.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Vec3 l = x_[s.a] - x_[s.b];
        blocks_[i] = k * stiffness_block(l, system.tension(i, norm(l)), clamped) + c * damping_block(s, l);
    }
    return solver_->factorize(diagonal_, blocks_);
}

void ImplicitTangent::solve(std::span<const double> r, std::span<double> u) {
    packing_.unpack(r, right_);
    for (std::size_t i = 0; i < right_.size(); ++i) right_[i] *= network_->mass[i];
    solver_->solve(right_, left_);
    packing_.pack(left_, u);
}

double ImplicitTangent::prepare_seconds() const noexcept {
    constexpr double kSpring = 40e-9;
    return solver_->factorize_seconds() + kSpring * static_cast<double>(blocks_.size());
}

double ImplicitTangent::solve_seconds() const noexcept { return solver_->solve_seconds(); }

std::size_t ImplicitTangent::memory_bytes() const noexcept {
    return solver_->memory_bytes() + x_.size() * (3 * sizeof(Vec3) + sizeof(double)) +
           blocks_.capacity() * sizeof(SymmetricBlock);
}

}  // namespace orbweaver::mass_spring
