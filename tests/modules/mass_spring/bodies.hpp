#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "integrator.hpp"
#include "network.hpp"
#include "orbweaver/random.hpp"
#include "spring_system.hpp"
#include "symmetric_block.hpp"

/// Small mass-spring bodies that several tests share.
namespace bodies {

using orbweaver::Vec3;
using orbweaver::mass_spring::Network;
using orbweaver::mass_spring::Spring;

constexpr double kPi = 3.14159265358979323846;

struct Body {
    Network network;
    std::vector<Vec3> x;  ///< m
    std::vector<Vec3> v;  ///< m/s

    std::uint32_t add(const Vec3& position, double mass, bool fixed = false) {
        network.mass.push_back(mass);
        network.fixed.push_back(fixed ? 1 : 0);
        x.push_back(position);
        v.push_back({});
        return static_cast<std::uint32_t>(x.size() - 1);
    }
    void join(std::uint32_t a, std::uint32_t b, double rest_length, double stiffness, double damping = 0) {
        network.springs.push_back({a, b, rest_length, stiffness, damping});
    }
};

/// Of a spring where its ends are.
inline orbweaver::mass_spring::SymmetricBlock stiffness_block(const Body& body, const Spring& s, bool clamped) {
    const Vec3 l = body.x[s.a] - body.x[s.b];
    return orbweaver::mass_spring::stiffness_block(
        l, orbweaver::mass_spring::tension_at(s, norm(l) - s.rest_length), clamped);
}

/// Every spring of a body softens, stiffens and relaxes, each a little differently.
inline void bend(Body& body) {
    double n = 0;
    for (Spring& s : body.network.springs) {
        const double each = 1 + 0.01 * n++;
        s.law = {0.5 * each, 0.4 * each * each, 0.7 * each * s.stiffness, 0.05 * each};
    }
}

/// A mass on a spring from a fixed point at the origin, along x, at rest.
inline Body oscillator(double mass, double stiffness, double damping = 0) {
    Body body;
    body.add({0, 0, 0}, mass, true);
    body.add({1, 0, 0}, mass);
    body.join(0, 1, 1, stiffness, damping);
    return body;
}

/// `beads` masses between two fixed ends on the x axis, `spacing` apart, every spring under `tension`.
inline Body bead_string(std::size_t beads, double spacing, double mass, double stiffness, double tension) {
    Body body;
    for (std::size_t i = 0; i < beads + 2; ++i) {
        body.add({spacing * static_cast<double>(i), 0, 0}, mass, i == 0 || i == beads + 1);
    }
    for (std::uint32_t i = 0; i + 1 < body.x.size(); ++i) {
        body.join(i, i + 1, spacing - tension / stiffness, stiffness);
    }
    return body;
}

/// A thread of `links` links between two fixed points `span` apart, laid as a shallow V, its mass at the
/// joints.
inline Body hanging_thread(std::size_t links, double span, double length, double mass, double stiffness) {
    Body body;
    const double each = mass / static_cast<double>(links);
    for (std::size_t i = 0; i <= links; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(links);
        const bool end = i == 0 || i == links;
        body.add({span * s, -0.1 * span * (1 - std::abs(2 * s - 1)), 0}, end ? each / 2 : each, end);
    }
    for (std::uint32_t i = 0; i < links; ++i)
        body.join(i, i + 1, length / static_cast<double>(links), stiffness);
    return body;
}

/// A lattice of n x n x n, 1 cm apart, its springs strained by `strain`, all of its surface fixed.
inline Body lattice(std::uint32_t n, double strain) {
    constexpr double kSpacing = 0.01, kMass = 1e-6, kStiffness = 1;
    Body body;
    const auto outermost = [n](std::uint32_t i) { return i == 0 || i + 1 == n; };
    for (std::uint32_t z = 0; z < n; ++z)
        for (std::uint32_t y = 0; y < n; ++y)
            for (std::uint32_t x = 0; x < n; ++x) {
                const bool fixed = outermost(x) || outermost(y) || outermost(z);
                const auto i = body.add({kSpacing * x, kSpacing * y, kSpacing * z}, kMass, fixed);
                if (x > 0) body.join(i - 1, i, kSpacing / (1 + strain), kStiffness);
                if (y > 0) body.join(i - n, i, kSpacing / (1 + strain), kStiffness);
                if (z > 0) body.join(i - n * n, i, kSpacing / (1 + strain), kStiffness);
            }
    return body;
}

/// A hub with `spokes` springs of 0.1 m, slightly taut, to fixed ends.
inline Body wheel(std::size_t spokes, double mass, double stiffness, double damping) {
    Body body;
    body.add({0, 0, 0}, mass);
    for (std::size_t i = 0; i < spokes; ++i) {
        const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(spokes);
        const auto end = body.add({0.1 * std::cos(angle), 0.1 * std::sin(angle), 0}, mass, true);
        body.join(0, end, 0.099, stiffness, damping);
    }
    return body;
}

/// Particles at random places with random velocities, each joined to three at random; none is fixed.
inline Body tangle(std::size_t particles, double damping) {
    const orbweaver::RandomStream random(3, "tangle");
    Body body;
    std::uint64_t n = 0;
    const auto vector = [&](double size) {
        const double x = random.uniform(n++, -size, size);
        const double y = random.uniform(n++, -size, size);
        return Vec3{x, y, random.uniform(n++, -size, size)};
    };
    for (std::size_t i = 0; i < particles; ++i) {
        body.add(vector(1), random.uniform(n++, 0.5, 2));
        body.v.back() = vector(1);
    }
    for (std::uint32_t i = 0; i < particles; ++i) {
        for (int j = 0; j < 3; ++j) {
            const auto other = static_cast<std::uint32_t>(random.bits(n++) % particles);
            const double rest_length = random.uniform(n++, 0.5, 1);
            const double stiffness = random.uniform(n++, 1, 5);
            if (other != i) body.join(i, other, rest_length, stiffness, damping);
        }
    }
    return body;
}

/// A hub with radii of 1 to 12 particles, neighbours joined ring by ring as far as both reach; every 11th
/// spring is double, every 3rd is written from its later end to its earlier.
inline Body ragged_web(double damping) {
    const orbweaver::RandomStream random(5, "ragged");
    Body body;
    body.add({0, 0, 0}, 1);
    std::vector<std::uint32_t> before;
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
        const std::size_t n = body.network.springs.size();
        const double stiffness = random.uniform(n, 1, 5);
        if (n % 3 == 0) std::swap(a, b);
        body.join(a, b, 0.9, stiffness, damping);
        if (n % 11 == 0) body.join(a, b, 0.8, stiffness, damping);
    };
    for (std::uint32_t spoke = 0; spoke < 24; ++spoke) {
        std::vector<std::uint32_t> radius;
        for (std::uint32_t ring = 0; ring < 1 + (7 * spoke) % 12; ++ring) {
            const double r = 1 + ring, angle = 2 * kPi * spoke / 24;
            radius.push_back(body.add({r * std::cos(angle), r * std::sin(angle), 0.1 * r * r}, 1 + 0.1 * ring));
            body.v.back() = {0.1 * r, -0.2 * angle, 0.3};
            join(ring == 0 ? 0 : radius[ring - 1], radius[ring]);
            if (ring < before.size()) join(before[ring], radius[ring]);
        }
        before = radius;
    }
    return body;
}

inline std::vector<Vec3> accelerations(orbweaver::mass_spring::SpringSystem& system, std::span<const Vec3> x,
                                       std::span<const Vec3> v) {
    std::vector<double> packed_x(system.length()), packed_v(system.length()), packed_a(system.length());
    system.packing().pack(x, packed_x);
    system.packing().pack(v, packed_v);
    system.accelerations(packed_x, packed_v, packed_a);
    std::vector<Vec3> a(x.size());
    system.packing().unpack(packed_a, a);
    return a;
}

inline bool same_bits(std::span<const Vec3> a, std::span<const Vec3> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

/// Where each of so many particles goes when they are numbered at random.
inline std::vector<std::uint32_t> shuffle(std::size_t particles) {
    const orbweaver::RandomStream random(1, "shuffle");
    std::vector<std::uint32_t> to(particles);
    for (std::uint32_t i = 0; i < particles; ++i) to[i] = i;
    for (std::size_t i = particles; i > 1; --i) std::swap(to[i - 1], to[random.bits(i) % i]);
    return to;
}

/// The same body, its particles numbered at random.
inline Body shuffled(const Body& body) {
    const std::vector<std::uint32_t> to = shuffle(body.x.size());
    Body mixed = body;
    for (std::size_t i = 0; i < to.size(); ++i) {
        mixed.network.mass[to[i]] = body.network.mass[i];
        mixed.network.fixed[to[i]] = body.network.fixed[i];
        mixed.x[to[i]] = body.x[i];
        mixed.v[to[i]] = body.v[i];
    }
    for (Spring& s : mixed.network.springs) {
        s.a = to[s.a];
        s.b = to[s.b];
    }
    return mixed;
}

}  // namespace bodies
