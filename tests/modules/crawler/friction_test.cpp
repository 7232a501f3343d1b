#include "friction.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "orbweaver/random.hpp"
#include "orbweaver/vec3.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;

namespace {

/// Two unit vectors at right angles, lying anyhow.
struct Axes {
    Vec3 spine{0.6, 0, 0.8};
    Vec3 side{-0.48, 0.8, 0.36};
    Vec3 vector(double along, double across) const { return along * spine + across * side; }
};

/// A velocity among other ones, whose lanes are not to matter.
Vec3 slide(const Friction& friction, double pressing, const Vec3& v, const Vec3& spine, const Vec3& side,
           double expected = 0) {
    const double along = dot(v, spine), across = dot(v, side);
    const Sliding slid =
        crawler::slide(friction, Lanes{7 * pressing, pressing, 0, 1e9},
                       {Lanes{-along, along, 0, 3}, Lanes{across, across, 0, -along}}, in_all(expected));
    return slid.along[1] * spine + slid.across[1] * side;
}

Friction coulomb(double forward, double backward, double sideways) {
    return {FrictionLaw::coulomb, forward, backward, sideways};
}

/// What friction bears for each m/s of pressing while a point slides with v: mu(u), along both axes.
struct Borne {
    double along, across;
};
Borne borne(const Friction& f, double along, double across) {
    const double speed = std::hypot(along, across);
    return {(along < 0 ? f.backward : f.forward) * along / speed, f.sideways * across / speed};
}

/// v' = -mu(u) over `pressing`, in `steps` steps of the classical Runge and Kutta.
Borne integrated(const Friction& f, double pressing, double along, double across, int steps) {
    const double h = pressing / steps;
    for (int i = 0; i < steps; ++i) {
        Borne slope[4];
        const double ahead[] = {0, h / 2, h / 2, h};
        for (int k = 0; k < 4; ++k) {
            const Borne last = k == 0 ? Borne{0, 0} : slope[k - 1];
            slope[k] = borne(f, along - ahead[k] * last.along, across - ahead[k] * last.across);
        }
        along -= h / 6 * (slope[0].along + 2 * slope[1].along + 2 * slope[2].along + slope[3].along);
        across -= h / 6 * (slope[0].across + 2 * slope[1].across + 2 * slope[2].across + slope[3].across);
    }
    return {along, across};
}

/// Random cases whose coefficients span 1e-3 to 1e3.
template <class Check>
void for_cases(int rounds, const Check& check) {
    const RandomStream random(11, "sliding");
    std::uint64_t n = 0;
    const auto size = [&] { return std::pow(10, random.uniform(n++, -3, 3)); };
    for (int i = 0; i < rounds; ++i) {
        const double forward = size(), backward = size(), sideways = size(), pressing = size();
        const double along = random.uniform(n++, -1, 1), across = random.uniform(n++, -1, 1);
        check(coulomb(forward, backward, sideways), pressing, along, across);
    }
}

}  // namespace

TEST_CASE("what the impulse can stop rests, and nothing else does", "[unit]") {
    const Axes axes;
    const Friction f = coulomb(0.2, 0.5, 0.4);
    const double pressing = 2;  // so that 0.4 m/s are stopped forward, 1 backward and 0.8 sideways
    for (int i = 0; i < 360; ++i) {
        const double angle = M_PI / 180 * i;
        const double along = std::cos(angle), across = std::sin(angle);
        const double rim = 1 / std::hypot(along / (along < 0 ? 1.0 : 0.4), across / 0.8);
        const Vec3 within =
            slide(f, pressing, axes.vector(0.999 * rim * along, 0.999 * rim * across), axes.spine, axes.side);
        CHECK(norm(within) == 0);
        const Vec3 beyond =
            slide(f, pressing, axes.vector(1.001 * rim * along, 1.001 * rim * across), axes.spine, axes.side);
        CHECK(norm(beyond) > 1e-4 * rim);  // a thousandth of the way, against what is at most 2.5 times more
    }
}

TEST_CASE("four velocities slide each as it would alone, whatever the others need", "[unit]") {
    const RandomStream random(5, "lanes");
    const Friction f = coulomb(0.1, 1, 0.3);
    std::uint64_t n = 0;
    for (int round = 0; round < 2000; ++round) {
        Lanes pressing, along, across;
        for (int i = 0; i < 4; ++i) {
            pressing[i] = i == 0 ? 0 : std::pow(10, random.uniform(n++, -4, 2));  // resting, sliding, free
            along[i] = random.uniform(n++, -1, 1);
            across[i] = i == 3 && round % 2 == 0 ? 0 : random.uniform(n++, -1, 1);
        }
        const Sliding all = crawler::slide(f, pressing, {along, across}, Lanes{});
        for (int i = 0; i < 4; ++i) {
            const Sliding alone =
                crawler::slide(f, in_all(pressing[i]), {in_all(along[i]), in_all(across[i])}, Lanes{});
            // Others may have the root found better than it needs.
            CHECK(all.along[i] == Approx(alone.along[i]).epsilon(1e-9));
            CHECK(all.across[i] == Approx(alone.across[i]).epsilon(1e-9));
        }
    }
}

TEST_CASE("what slides ends as friction in its last direction has it", "[unit]") {
    const Axes axes;
    int slid = 0;
    for_cases(20000, [&](const Friction& f, double pressing, double along, double across) {
        const Vec3 v = axes.vector(along, across);
        const Vec3 end = slide(f, pressing, v, axes.spine, axes.side);
        if (norm(end) == 0) return;
        ++slid;
        const double to = dot(end, axes.spine), aside = dot(end, axes.side);
        const Borne of = borne(f, to, aside);
        // The speed is found to 1e-9 of itself at worst, and impulses may be a thousand times more than it.
        const double rounding = 1e-12 + 1e-9 * (std::abs(along - to) + std::abs(across - aside));
        CHECK(std::abs(to - (along - pressing * of.along)) < rounding);
        CHECK(std::abs(aside - (across - pressing * of.across)) < rounding);
        CHECK(std::abs(dot(end, cross(axes.spine, axes.side))) < 1e-15);
    });
    CHECK(slid > 5000);
}

TEST_CASE("what is expected of the end speed changes nothing", "[unit]") {
    const Axes axes;
    for_cases(2000, [&](const Friction& f, double pressing, double along, double across) {
        const Vec3 v = axes.vector(along, across);
        const Vec3 end = slide(f, pressing, v, axes.spine, axes.side);
        for (const double expected :
             {1e-300, 1e-3 * norm(end), 0.99 * norm(end), norm(end), 2 * norm(v), 1e300, HUGE_VAL}) {
            const Vec3 other = slide(f, pressing, v, axes.spine, axes.side, expected);
            CHECK(distance(other, end) <= 2e-9 * norm(v));
        }
    });
    // Next to nothing slides on where there is no friction, whatever it did before.
    const Vec3 tiny = 1e-300 * axes.spine;
    CHECK(distance(slide(coulomb(0, 0, 0), 1, tiny, axes.spine, axes.side, 1e3), tiny) < 1e-312);
}

TEST_CASE("friction takes energy and never turns a motion round", "[unit]") {
    const Axes axes;
    for_cases(20000, [&](const Friction& f, double pressing, double along, double across) {
        const Vec3 end = slide(f, pressing, axes.vector(along, across), axes.spine, axes.side);
        const double to = dot(end, axes.spine), aside = dot(end, axes.side);
        CHECK(to * along >= 0);
        CHECK(aside * across >= 0);
        CHECK(std::abs(to) <= std::abs(along) * (1 + 1e-15));
        CHECK(std::abs(aside) <= std::abs(across) * (1 + 1e-15));
    });
}

TEST_CASE("pressed little by little, a point slides as the equation of motion has it", "[unit]") {
    const Axes axes;
    for (const auto& f : {coulomb(0.1, 0.15, 1), coulomb(0.3, 0.1, 0.2), coulomb(1, 3, 0.1)})
        for (const auto& [along, across] : {std::pair{0.8, 0.6}, {-0.8, 0.5}, {0.1, -1.0}, {-0.3, -0.9}}) {
            const double pressing = 0.3 / std::max({f.forward, f.backward, f.sideways});
            const Borne expected = integrated(f, pressing, along, across, 2000);
            double before = 0;
            for (const int parts : {40, 80, 160}) {
                Vec3 v = axes.vector(along, across);
                for (int i = 0; i < parts; ++i) v = slide(f, pressing / parts, v, axes.spine, axes.side);
                const double off = distance(v, axes.vector(expected.along, expected.across));
                CHECK(off < 0.1 / parts);  // implicit Euler: of first order
                if (before > 0) CHECK(before / off == Approx(2).epsilon(0.05));
                before = off;
            }
        }
}

TEST_CASE("the same friction all round takes a speed and leaves its direction", "[unit]") {
    const Axes axes;
    for (const double speed : {0.1, 1.0, 7.0})
        for (const double angle : {0.0, 0.7, 2.0, 4.0}) {
            const Vec3 v = axes.vector(speed * std::cos(angle), speed * std::sin(angle));
            const Vec3 end = slide(coulomb(0.3, 0.3, 0.3), 2, v, axes.spine, axes.side);
            CHECK(distance(end, std::max(0.0, 1 - 0.6 / speed) * v) < 1e-9 * speed);
        }
}

TEST_CASE("along an axis a speed falls by its own coefficient times the pressing", "[unit]") {
    const Axes axes;
    const Friction f = coulomb(0.1, 0.3, 0.2);
    const auto end = [&](double along, double across) {
        return slide(f, 0.5, axes.vector(along, across), axes.spine, axes.side);
    };
    CHECK(distance(end(1, 0), axes.vector(0.95, 0)) < 1e-9);
    CHECK(distance(end(-1, 0), axes.vector(-0.85, 0)) < 1e-9);
    CHECK(distance(end(0, 1), axes.vector(0, 0.9)) < 1e-9);
    CHECK(distance(end(0, -1), axes.vector(0, -0.9)) < 1e-9);
}

TEST_CASE("without friction, pressing or motion nothing changes", "[unit]") {
    const Axes axes;
    const Vec3 v = axes.vector(-0.3, 0.7);
    CHECK(distance(slide(coulomb(0, 0, 0), 5, v, axes.spine, axes.side), v) < 1e-16);
    CHECK(distance(slide(coulomb(0.1, 0.2, 0.3), 0, v, axes.spine, axes.side), v) < 1e-16);
    for (const double mu : {0.0, 0.3, 1e300}) {
        const Friction f = coulomb(mu, mu, mu);
        CHECK(slide(f, 5, {}, axes.spine, axes.side) == Vec3{});
        CHECK(slide(f, 0, {}, axes.spine, axes.side) == Vec3{});
    }
}

TEST_CASE("where one way bears nothing, its part of the motion goes on", "[unit]") {
    const Axes axes;
    const auto end = [&](const Friction& f, double along, double across) {
        const Vec3 v = slide(f, 0.5, axes.vector(along, across), axes.spine, axes.side);
        return std::pair{dot(v, axes.spine), dot(v, axes.side)};
    };
    for (const double mu : {0.01, 0.3, 1.0, 1e3}) {
        // Skates: the other part falls as if the whole speed were its end.
        const auto [to, aside] = end(coulomb(0, mu, mu), 1, 0.6);
        CHECK(to == Approx(1).epsilon(1e-9));
        const double speed = std::hypot(to, aside);
        CHECK(aside * (speed + 0.5 * mu) == Approx(0.6 * speed).epsilon(1e-8));
        const auto [on, across] = end(coulomb(mu, mu, 0), -0.4, 0.6);
        CHECK(across == Approx(0.6).epsilon(1e-9));
        CHECK(on * (std::hypot(on, across) + 0.5 * mu) == Approx(-0.4 * std::hypot(on, across)).epsilon(1e-8));
        // Backward has its own: here it bears all that forward does not.
        CHECK(end(coulomb(mu, 0, mu), -1, 0).first == -1);
        CHECK(end(coulomb(0, mu, mu), 1, 0).first == 1);
        CHECK(end(coulomb(mu, mu, 0), 0, 2).second == 2);
    }
}

TEST_CASE("enormous coefficients hold everything, and small ones beside them are not lost", "[unit]") {
    const Axes axes;
    for (const double mu : {1e6, 1e100, 1e300})
        for (const double angle : {0.1, 1.0, 2.5, 5.0}) {
            const Vec3 v = axes.vector(100 * std::cos(angle), 100 * std::sin(angle));
            CHECK(slide(coulomb(mu, mu, mu), 1e-3, v, axes.spine, axes.side) == Vec3{});
        }
    // Nothing gets aside; along, friction is as if nothing moved aside.
    const Vec3 end = slide(coulomb(0.1, 0.1, 1e100), 2, axes.vector(1, 1), axes.spine, axes.side);
    CHECK(distance(end, axes.vector(0.8, 0)) < 1e-9);
}

TEST_CASE("sliding twice as fast under twice the impulse ends twice as fast", "[unit]") {
    const Axes axes;
    for_cases(1000, [&](const Friction& f, double pressing, double along, double across) {
        const Vec3 once = slide(f, pressing, axes.vector(along, across), axes.spine, axes.side);
        const Vec3 scaled =
            slide(f, 1024 * pressing, axes.vector(1024 * along, 1024 * across), axes.spine, axes.side);
        CHECK(distance(scaled, 1024 * once) <= 1e-12);  // a power of two is exact but for nothing
    });
}

TEST_CASE("a one-way clamp stops what slides backward, however it is pressed, and leaves all else", "[unit]") {
    const Axes axes;
    const Friction clamp{FrictionLaw::one_way, 0.3, 0.3, 0.3};
    for (const double pressing : {0.0, 1.0, 1e300}) {
        for (const double across : {-0.7, 0.0, 2.0}) {
            const Vec3 on = axes.vector(0.4, across);
            CHECK(norm(slide(clamp, pressing, on, axes.spine, axes.side) - on) < 1e-15);
            const Vec3 back = slide(clamp, pressing, axes.vector(-0.4, across), axes.spine, axes.side);
            CHECK(distance(back, axes.vector(0, across)) < 1e-15);
        }
    }
}
