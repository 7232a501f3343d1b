#pragma once

#include "method.hpp"

namespace orbweaver::mass_spring {

// One line per file of a method; methods.cpp gathers them into the table.
std::unique_ptr<Method> make_explicit_euler(std::size_t length);
std::unique_ptr<Method> make_symplectic_euler(std::size_t length);
std::unique_ptr<Method> make_verlet(std::size_t length);
std::unique_ptr<Method> make_rk4(std::size_t length);
std::unique_ptr<Method> make_tsit5(std::size_t length);
std::unique_ptr<Method> make_srkn6(std::size_t length);
std::unique_ptr<Method> make_rkc2(std::size_t length);
std::unique_ptr<Method> make_implicit_euler(std::size_t length);
std::unique_ptr<Method> make_tr_bdf2(std::size_t length);
std::unique_ptr<Method> make_provot(std::size_t length);
std::unique_ptr<Method> make_xpbd(std::size_t length);

}  // namespace orbweaver::mass_spring
