#include <algorithm>
#include <array>
#include <cstdint>

#include "builtin_methods.hpp"

namespace orbweaver::mass_spring {

std::span<const MethodInfo> methods() noexcept {
    static constexpr std::array<MethodInfo, 11> table{{
        // As MethodInfo has them.
        {"explicit_euler", 1, 0, 1, make_explicit_euler, false, 0, {}, 0.5, -0.5},
        {"symplectic_euler", 1, 0, 1, make_symplectic_euler, false, 0, {}, 0.5, 0.5},
        {"verlet", 2, 0, 2, make_verlet},
        {"rk4", 4, 0, 4, make_rk4},
        {"tsit5", 5, 4, 6, make_tsit5},
        {"srkn6", 6, 0, 12, make_srkn6, true, 3.1414},
        {"rkc2", 2, 2, 0, make_rkc2},
        {"implicit_euler", 1, 0, 1, make_implicit_euler, false, 0, {}, -0.5, 0.5},
        {"tr_bdf2", 2, 2, 0, make_tr_bdf2},
        {"provot", 1, 0, 1, make_provot, false, 0, "tr_bdf2", 0.5, 0.5},
        {"xpbd", 1, 0, 0, make_xpbd, false, 0, "tr_bdf2", -0.5, 0.5},
    }};
    return table;
}

namespace {

template <class Is>
const MethodInfo* find_if(const Is& is) noexcept {
    const auto all = methods();
    const auto found = std::find_if(all.begin(), all.end(), is);
    return found == all.end() ? nullptr : &*found;
}

}  // namespace

const MethodInfo* find_method(std::string_view name) noexcept {
    return find_if([&](const MethodInfo& m) { return m.name == name; });
}

std::uint64_t method_key(const MethodInfo& method) noexcept {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : method.name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

const MethodInfo* find_method(std::uint64_t key) noexcept {
    return find_if([&](const MethodInfo& m) { return method_key(m) == key; });
}

}  // namespace orbweaver::mass_spring
