#include "spring_kernel.hpp"

#include "drag_drift.hpp"
#include "lanes.hpp"
#include "spring_force.hpp"

namespace orbweaver::mass_spring {
namespace {

/// See tension_at() for the arithmetic, which is the same.
ORBWEAVER_INLINE void bend(const SpringTable::Law& law, const Lanes& extension, const double* creep,
                           Lanes& force) noexcept {
    const Lanes e = extension > 0 ? extension : Lanes{};
    force *= 1 + e * (load(law.stiffening.data()) * e - load(law.softening.data()));
    if (creep != nullptr) force += load(law.arm.data()) * (extension - load(creep));
}

/// See pull_factor() for the arithmetic, which is the same.
template <bool damped, bool lawful>
ORBWEAVER_INLINE void pulls(const SpringTable& table, const KernelInput& input, std::size_t begin,
                            std::size_t end, double* pull) noexcept {
    const std::size_t plane = table.packing.plane();
    for (std::size_t i = begin; i < end; ++i) {
        const SpringTable::Quad& quad = table.quads[i];
        const Vec3Lanes l = load(input.x + quad.a, plane) - load(input.x + quad.b, plane);
        const Lanes length = sqrt(dot(l, l));
        const Lanes inverse = 1 / (length + kNoLength);
        const Lanes extension = length - load(quad.rest_length.data());
        Lanes force = load(quad.stiffness.data()) * extension;
        if constexpr (lawful)
            bend(table.laws[i], extension, input.creep != nullptr ? input.creep + i * Packing::kLanes : nullptr,
                 force);
        if constexpr (damped) {
            const Vec3Lanes dl = load(input.v + quad.a, plane) - load(input.v + quad.b, plane);
            force += load(table.damping[i].data()) * dot(l, dl) * inverse;
        }
        store(pull + quad.slot, table.slots, l * (force * inverse));
    }
}

ORBWEAVER_INLINE void any_pulls(const SpringTable& table, const KernelInput& input, std::size_t begin,
                                std::size_t end, double* pull) noexcept {
    const bool damped = !table.damping.empty() && input.v != nullptr;
    if (!table.laws.empty()) {
        damped ? pulls<true, true>(table, input, begin, end, pull)
               : pulls<false, true>(table, input, begin, end, pull);
    } else {
        damped ? pulls<true, false>(table, input, begin, end, pull)
               : pulls<false, false>(table, input, begin, end, pull);
    }
}

/// q - e shrinks by 1/(1 + z + z^2/2), z = h/tau, which is exp(-z) to second order and never oscillates.
ORBWEAVER_INLINE void any_creep(const SpringTable& table, const double* x, double h, std::size_t begin,
                                std::size_t end, double* creep) noexcept {
    const std::size_t plane = table.packing.plane();
    for (std::size_t i = begin; i < end; ++i) {
        const SpringTable::Quad& quad = table.quads[i];
        const Vec3Lanes l = load(x + quad.a, plane) - load(x + quad.b, plane);
        const Lanes extension = sqrt(dot(l, l)) - load(quad.rest_length.data());
        const Lanes z = h * load(table.laws[i].relaxation_rate.data());
        double* q = creep + i * Packing::kLanes;
        store(q, extension + (load(q) - extension) / (1 + z * (1 + 0.5 * z)));
    }
}

/// Of the springs of a quad.
struct Extent {
    Vec3Lanes l;    // m, from b to a
    Lanes length;   // m
    Lanes inverse;  // 1/m
    Lanes along;    // m^2/s, the velocity of a seen from b, along l
    Lanes rate;     // m/s, by which the length grows
};

ORBWEAVER_INLINE Extent extent_of(const SpringTable::Quad& quad, const KernelInput& input,
                                  std::size_t plane) noexcept {
    Extent of;
    of.l = load(input.x + quad.a, plane) - load(input.x + quad.b, plane);
    const Vec3Lanes dl = load(input.v + quad.a, plane) - load(input.v + quad.b, plane);
    of.length = sqrt(dot(of.l, of.l));
    of.inverse = 1 / (of.length + kNoLength);
    of.along = dot(of.l, dl);
    of.rate = of.along * of.inverse;
    return of;
}

ORBWEAVER_INLINE void any_remember(const SpringTable& table, DrivenQuad* driven, const KernelInput& input,
                                   std::size_t begin, std::size_t end) noexcept {
    for (std::size_t i = begin; i < end; ++i) {
        const Extent now = extent_of(table.quads[i], input, table.packing.plane());
        store(driven[i].length.data(), now.length);
        store(driven[i].rate.data(), now.rate);
    }
}

/// See pulls() for the arithmetic of the forces, which is the same.
template <bool damped>
ORBWEAVER_INLINE DriveWork drive(SpringTable& table, DrivenQuad* driven, double share, double lag,
                                 const KernelInput& input, std::size_t begin, std::size_t end,
                                 double* pull) noexcept {
    const std::size_t plane = table.packing.plane();
    Lanes doubled_work{}, doubled_loss{};
    for (std::size_t i = begin; i < end; ++i) {
        SpringTable::Quad& quad = table.quads[i];
        DrivenQuad& path = driven[i];
        const Extent now = extent_of(quad, input, plane);
        const Lanes grown = now.length - load(path.length.data()), last_rate = load(path.rate.data());
        const Lanes stiffness = load(quad.stiffness.data()), before = load(quad.rest_length.data());
        const Lanes from = load(path.begin.data());
        const Lanes after = from + share * (load(path.end.data()) - from);
        doubled_work += stiffness * (after - before) * (after + before - 2 * (now.length - lag * grown));
        Lanes force = stiffness * (now.length - after);
        if constexpr (damped) {
            const Lanes damping = load(table.damping[i].data());
            doubled_loss += damping * (last_rate + now.rate) * grown;
            force += damping * now.along * now.inverse;
        }
        store(quad.rest_length.data(), after);
        store(path.length.data(), now.length);
        store(path.rate.data(), now.rate);
        store(pull + quad.slot, table.slots, now.l * (force * now.inverse));
    }
    return {0.5 * sum(doubled_work), 0.5 * sum(doubled_loss)};
}

ORBWEAVER_INLINE DriveWork any_drive(SpringTable& table, DrivenQuad* driven, double share, double lag,
                                     const KernelInput& input, std::size_t begin, std::size_t end,
                                     double* pull) noexcept {
    return table.damping.empty() ? drive<false>(table, driven, share, lag, input, begin, end, pull)
                                 : drive<true>(table, driven, share, lag, input, begin, end, pull);
}

/// Zero in the lanes whose bit is set.
ORBWEAVER_INLINE void hold(std::uint32_t lanes, Vec3Lanes& v) noexcept {
    for (std::size_t j = 0; j < Packing::kLanes; ++j) {
        if ((lanes >> j & 1) != 0) v.x[j] = v.y[j] = v.z[j] = 0;
    }
}

/// Of block i of particles, N: what springs pull, and what acts from outside but drag.
ORBWEAVER_INLINE Vec3Lanes block_force(const SpringTable& table, const KernelInput& input, const double* pull,
                                       std::size_t i) noexcept {
    const SpringTable::Block block = table.blocks[i];
    const std::uint32_t* slot = table.incident.data();
    Vec3Lanes sum{};
    for (std::uint32_t e = block.first; e < block.first_as_b; ++e)
        sum = sum - load(pull + slot[e], table.slots);
    for (std::uint32_t e = block.first_as_b; e < block.end; ++e) sum = sum + load(pull + slot[e], table.slots);
    if (input.external != nullptr)
        sum = sum + load(input.external + i * Packing::kLanes, table.packing.plane());
    return sum;
}

ORBWEAVER_INLINE Vec3Lanes block_acceleration(const SpringTable& table, const KernelInput& input,
                                              const Vec3Lanes& force, std::size_t i) noexcept {
    const Vec3Lanes gravity{Lanes{} + input.gravity.x, Lanes{} + input.gravity.y, Lanes{} + input.gravity.z};
    Vec3Lanes a = force * load(&table.inverse_mass[i * Packing::kLanes]) + gravity;
    if (table.blocks[i].held != 0) hold(table.blocks[i].held, a);
    return a;
}

ORBWEAVER_INLINE void any_accelerations(const SpringTable& table, const KernelInput& input, const double* pull,
                                        std::size_t begin, std::size_t end, double* a) noexcept {
    const std::size_t plane = table.packing.plane();
    const Lanes drag = Lanes{} + input.drag;
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t particle = i * Packing::kLanes;
        const Vec3Lanes force = block_force(table, input, pull, i) - load(input.v + particle, plane) * drag;
        store(a + particle, plane, block_acceleration(table, input, force, i));
    }
}

ORBWEAVER_INLINE void any_kicks(const SpringTable& table, const KernelInput& input, const double* pull,
                                const KickAndDrift& move, std::size_t begin, std::size_t end) noexcept {
    const std::size_t plane = table.packing.plane();
    const Lanes kick = Lanes{} + move.kick;
    const Lanes drag = Lanes{} + input.drag;
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t particle = i * Packing::kLanes;
        const Vec3Lanes a = block_acceleration(table, input, block_force(table, input, pull, i), i);
        const auto dragged = drift_under_drag(drag * load(&table.inverse_mass[particle]), move.drift);
        const Vec3Lanes v = load(move.v + particle, plane) + a * kick;
        store(move.x + particle, plane, load(move.x + particle, plane) + v * dragged.way);
        store(move.v + particle, plane, v - v * dragged.loss);
    }
}

void plain_pulls(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                 double* pull) noexcept {
    any_pulls(table, input, begin, end, pull);
}

void plain_accelerations(const SpringTable& table, const KernelInput& input, const double* pull,
                         std::size_t begin, std::size_t end, double* a) noexcept {
    any_accelerations(table, input, pull, begin, end, a);
}

void plain_kicks(const SpringTable& table, const KernelInput& input, const double* pull,
                 const KickAndDrift& move, std::size_t begin, std::size_t end) noexcept {
    any_kicks(table, input, pull, move, begin, end);
}

void plain_creep(const SpringTable& table, const double* x, double h, std::size_t begin, std::size_t end,
                 double* creep) noexcept {
    any_creep(table, x, h, begin, end, creep);
}

void plain_remember(const SpringTable& table, DrivenQuad* driven, const KernelInput& input, std::size_t begin,
                    std::size_t end) noexcept {
    any_remember(table, driven, input, begin, end);
}

DriveWork plain_drive(SpringTable& table, DrivenQuad* driven, double share, double lag,
                      const KernelInput& input, std::size_t begin, std::size_t end, double* pull) noexcept {
    return any_drive(table, driven, share, lag, input, begin, end, pull);
}

void wide_pulls(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                double* pull) noexcept {
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE { any_pulls(table, input, begin, end, pull); });
}

void wide_accelerations(const SpringTable& table, const KernelInput& input, const double* pull,
                        std::size_t begin, std::size_t end, double* a) noexcept {
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE { any_accelerations(table, input, pull, begin, end, a); });
}

void wide_kicks(const SpringTable& table, const KernelInput& input, const double* pull,
                const KickAndDrift& move, std::size_t begin, std::size_t end) noexcept {
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE { any_kicks(table, input, pull, move, begin, end); });
}

void wide_creep(const SpringTable& table, const double* x, double h, std::size_t begin, std::size_t end,
                double* creep) noexcept {
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE { any_creep(table, x, h, begin, end, creep); });
}

void wide_remember(const SpringTable& table, DrivenQuad* driven, const KernelInput& input, std::size_t begin,
                   std::size_t end) noexcept {
    run_wide([&]() ORBWEAVER_ALWAYS_INLINE { any_remember(table, driven, input, begin, end); });
}

DriveWork wide_drive(SpringTable& table, DrivenQuad* driven, double share, double lag, const KernelInput& input,
                     std::size_t begin, std::size_t end, double* pull) noexcept {
    return run_wide([&]() ORBWEAVER_ALWAYS_INLINE {
        return any_drive(table, driven, share, lag, input, begin, end, pull);
    });
}

}  // namespace

const SpringKernels& plain_kernels() noexcept {
    static constexpr SpringKernels kernels{plain_pulls, plain_accelerations, plain_kicks,
                                           plain_creep, plain_remember,      plain_drive};
    return kernels;
}

const SpringKernels* wide_kernels() noexcept {
    static constexpr SpringKernels kernels{wide_pulls, wide_accelerations, wide_kicks,
                                           wide_creep, wide_remember,      wide_drive};
    return has_avx2() ? &kernels : nullptr;
}

const SpringKernels& best_kernels() noexcept {
    const SpringKernels* wide = wide_kernels();
    return wide != nullptr ? *wide : plain_kernels();
}

}  // namespace orbweaver::mass_spring
