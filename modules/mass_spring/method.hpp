#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>

#include "spring_system.hpp"
#include "step_budget.hpp"

namespace orbweaver::mass_spring {

/// One method of integration. Holds scratch memory only: everything that a restart needs is x and v.
class Method {
public:
    virtual ~Method() = default;
    /// Advances x and v, of system.length() numbers each, in place by h seconds.
    virtual void step(DynamicSystem& system, std::span<double> x, std::span<double> v, double h) = 0;
    /// How far the last step may be off, m: what it differs by from the embedded method's, in a position or, as
    /// the way of one step, in a velocity; not finite where that means nothing. Only of methods with an
    /// embedded order.
    virtual double error(DynamicSystem&) { return std::numeric_limits<double>::infinity(); }
    /// Steps go on from a state that may not be where the last one ended: nothing kept may matter any more.
    /// That goes for a factorisation too: what Newton's method ends in rests on it to within its tolerance, and
    /// a restored run, which must come to the same bits, has none.
    virtual void begin() noexcept {}
    /// While it is not null, parts that a step is divided into, beyond the step itself, are taken from it. A
    /// step to which they are refused ends in velocities that are not numbers.
    virtual void use_budget(StepBudget*) noexcept {}
    virtual std::size_t memory_bytes() const noexcept = 0;  ///< of the scratch
};

/// A row of the table of methods: all that the rest of the house knows of one.
struct MethodInfo {
    std::string_view name;   ///< as scenes write it
    int order = 0;           ///< of global convergence
    int embedded_order = 0;  ///< the error of a step shrinks with h to this + 1; 0: it gives none
    int evaluations = 0;     ///< of the forces, per step that follows another; 0: as many as it takes
    std::unique_ptr<Method> (*make)(std::size_t length);
    bool undamped = false;  ///< takes systems whose springs are not damped, which drag may be all the same
    /// h omega of the first resonance, in which undamped modes grow although faster ones do not; 0: there is
    /// none.
    double resonance = 0;
    /// The method that tells how far this one is off, where half the step would not: empty for those that
    /// converge to the motion of the equations with no more ado.
    std::string_view judge{};
    /// Steps by which the middle of the way on which a step's forces work is older than its begin: half of one
    /// where they act where it begins, minus half of one where it ends.
    double lag = 0;
    /// Steps by which velocities are older than the positions that they are told with: half of one where
    /// positions moved by them, minus half of one where they will.
    double velocity_lag = 0;
};

/// Every method there is, in the order documents list them.
std::span<const MethodInfo> methods() noexcept;
/// The method of that name, or null.
const MethodInfo* find_method(std::string_view name) noexcept;
/// By which states tell a method, whatever others there are: a hash of its name (FNV-1a of 64 bits).
std::uint64_t method_key(const MethodInfo& method) noexcept;
/// The method of that key, or null.
const MethodInfo* find_method(std::uint64_t key) noexcept;

}  // namespace orbweaver::mass_spring
