#include "leg_solver.hpp"

#include <algorithm>
#include <array>

#include "solvers.hpp"

namespace orbweaver::spider {

std::span<const LegSolver> leg_solvers() noexcept {
    static constexpr std::array<LegSolver, 4> table{{
        // name, solve, whether it orients the last bone, whether it keeps limits
        {"half_jacobian", solve_half_jacobian, false, true},
        {"full_jacobian", solve_full_jacobian, true, true},
        {"fabrik", solve_fabrik, false, true},
        {"fabrik_unlimited", solve_fabrik_unlimited, false, false},
    }};
    return table;
}

const LegSolver* find_leg_solver(std::string_view name) noexcept {
    const auto all = leg_solvers();
    const auto found = std::find_if(all.begin(), all.end(), [&](const LegSolver& s) { return s.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace orbweaver::spider
