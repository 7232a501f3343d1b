#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "problem.hpp"

namespace orbweaver::peers {

/// y' = f(y) of a problem for solvers of ordinary differential equations: y holds all positions (m), then all
/// velocities (m/s), each in the right side's own layout.
class RightSide {
public:
    virtual ~RightSide() = default;
    virtual std::string_view name() const noexcept = 0;
    virtual std::size_t length() const noexcept = 0;  ///< of y
    virtual void pack(const Problem& problem, double* y) const = 0;
    virtual std::vector<Vec3> positions(const double* y) const = 0;
    virtual void evaluate(const double* y, double* rate) = 0;
};

/// As a textbook writes it: a structure per particle's vector and per spring, one loop over the springs that
/// adds their forces to both ends. `problem` must outlive it.
std::unique_ptr<RightSide> make_plain_right_side(const Problem& problem);
/// By SpringSystem::accelerations(). `problem` must outlive it.
std::unique_ptr<RightSide> make_fast_right_side(const Problem& problem);

using MakeRightSide = std::unique_ptr<RightSide> (*)(const Problem& problem);
inline constexpr MakeRightSide kRightSides[] = {make_plain_right_side, make_fast_right_side};

}  // namespace orbweaver::peers
