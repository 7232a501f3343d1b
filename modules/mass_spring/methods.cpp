#include <algorithm>
#include <array>

#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {

std::span<const MethodInfo> methods() noexcept {
    static constexpr std::array<MethodInfo, 6> table{{
        // name, order, evaluations, make
        {"explicit_euler", 1, 1, make_explicit_euler},
        {"symplectic_euler", 1, 1, make_symplectic_euler},
        {"verlet", 2, 2, make_verlet},
        {"rk4", 4, 4, make_rk4},
        {"implicit_euler", 1, 1, make_implicit_euler},
        {"sdirk2", 2, 0, make_sdirk2},
    }};
    return table;
}

const MethodInfo* find_method(std::string_view name) noexcept {
    const auto all = methods();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const MethodInfo& m) { return m.name == name; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace orbweaver::mass_spring
