#include <algorithm>
#include <array>
#include <cstdint>

#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {

std::span<const MethodInfo> methods() noexcept {
    static constexpr std::array<MethodInfo, 11> table{{
        // name, order, embedded order, evaluations, make, whether springs must not be damped, resonance, judge
        {"explicit_euler", 1, 0, 1, make_explicit_euler},
        {"symplectic_euler", 1, 0, 1, make_symplectic_euler},
        {"verlet", 2, 0, 2, make_verlet},
        {"rk4", 4, 0, 4, make_rk4},
        {"tsit5", 5, 4, 6, make_tsit5},
        {"srkn6", 6, 0, 12, make_srkn6, true, 3.1414},
        {"rkc2", 2, 2, 0, make_rkc2},
        {"implicit_euler", 1, 0, 1, make_implicit_euler},
        {"tr_bdf2", 2, 2, 0, make_tr_bdf2},
        {"provot", 1, 0, 1, make_provot, false, 0, "tr_bdf2"},
        {"xpbd", 1, 0, 0, make_xpbd, false, 0, "tr_bdf2"},
    }};
    return table;
}

const MethodInfo* find_method(std::string_view name) noexcept {
    const auto all = methods();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const MethodInfo& m) { return m.name == name; });
    return found == all.end() ? nullptr : &*found;
}

double mark_of(const MethodInfo& method) noexcept {
    std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a of 64 bits
    for (const char letter : method.name) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
    return static_cast<double>(hash >> 12);  // which a double holds
}

const MethodInfo* find_marked_method(double mark) noexcept {
    const auto all = methods();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const MethodInfo& m) { return mark_of(m) == mark; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace orbweaver::mass_spring
