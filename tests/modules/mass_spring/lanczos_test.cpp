#include "lanczos.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

std::vector<Vec3> start_vector(std::size_t n) {
    std::vector<Vec3> start(n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto t = static_cast<double>(i);
        start[i] = {1 + std::sin(3 * t), std::cos(7 * t), std::sin(11 * t + 1)};
    }
    return start;
}

}  // namespace

TEST_CASE("the largest eigenvalue of a diagonal is its largest entry", "[unit]") {
    const auto apply = [](std::span<const Vec3> in, std::span<Vec3> out) {
        for (std::size_t i = 0; i < in.size(); ++i) {
            const auto d = static_cast<double>(i);
            out[i] = {d * in[i].x, 0.5 * d * in[i].y, -d * in[i].z};
        }
    };
    const EigenPair pair = largest_eigenpair(apply, start_vector(50), 1e-8);
    CHECK(pair.value == Approx(49).epsilon(1e-10));
    CHECK(std::abs(pair.vector[49].x) == Approx(1).epsilon(1e-6));
}

TEST_CASE("the largest eigenvalue of a chain is 4 sin^2(n pi/(2 (n + 1)))", "[unit]") {
    constexpr std::size_t kLinks = 200;
    const auto apply = [](std::span<const Vec3> in, std::span<Vec3> out) {
        for (std::size_t i = 0; i < in.size(); ++i) {
            out[i] = 2 * in[i];
            if (i > 0) out[i] -= in[i - 1];
            if (i + 1 < in.size()) out[i] -= in[i + 1];
        }
    };
    const EigenPair pair = largest_eigenpair(apply, start_vector(kLinks), 1e-4);
    const double sine = std::sin(kLinks * bodies::kPi / (2 * (kLinks + 1)));
    CHECK(pair.value == Approx(4 * sine * sine).epsilon(1e-4));
    CHECK(pair.value <= 4 * sine * sine * (1 + 1e-10));
}

TEST_CASE("operators that do nothing and vectors of nothing have an answer", "[unit]") {
    const auto zero = [](std::span<const Vec3> in, std::span<Vec3> out) {
        for (std::size_t i = 0; i < in.size(); ++i) out[i] = {};
    };
    CHECK(std::abs(largest_eigenpair(zero, start_vector(9), 1e-4).value) < 1e-300);
    CHECK(largest_eigenpair(zero, std::vector<Vec3>(9), 1e-4).vector.empty());
    const auto identity = [](std::span<const Vec3> in, std::span<Vec3> out) {
        for (std::size_t i = 0; i < in.size(); ++i) out[i] = 3 * in[i];
    };
    CHECK(largest_eigenpair(identity, start_vector(9), 1e-4).value == Approx(3).epsilon(1e-12));
    const auto negative = [](std::span<const Vec3> in, std::span<Vec3> out) {
        for (std::size_t i = 0; i < in.size(); ++i) out[i] = -3 * in[i];
    };
    CHECK(largest_eigenpair(negative, start_vector(9), 1e-4).value == Approx(-3).epsilon(1e-12));
}
