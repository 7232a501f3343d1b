#include "spring_kernel.hpp"

#include <catch2/catch.hpp>
#include <thread>

#include "bodies.hpp"
#include "spring_system.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

/// Two threads and ranges of awkward, changing lengths.
class TwoWorkers final : public Workers {
public:
    void parallel_for(std::size_t count, std::size_t grain, Body body, void* context) noexcept override {
        ++calls;
        const std::size_t cut = std::min(count, grain + 1 + calls % 7);
        std::thread other([&] { body(context, cut, count); });
        body(context, 0, cut);
        other.join();
    }
    std::size_t calls = 0;
};

std::vector<Vec3> accelerations_of(const Body& body, const Surroundings& around, const SpringKernels& kernels,
                                   Workers* workers) {
    SpringSystem system(body.network, workers);
    system.put_on_arms(std::vector<Vec3>(body.x.rbegin(), body.x.rend()));
    system.set_surroundings(around);
    system.use_kernels(kernels);
    std::vector<double> packed(system.length());
    system.packing().pack(body.x, packed);
    if (system.creep_count() > 0) system.creep(packed, 0.01);
    return bodies::accelerations(system, body.x, body.v);
}

/// Where an eleventh of a step leads: x, then v.
std::vector<Vec3> kicked(Body body, const Surroundings& around, const SpringKernels& kernels,
                         Workers* workers) {
    SpringSystem system(body.network, workers);
    system.set_surroundings(around);
    system.use_kernels(kernels);
    std::vector<double> x(system.length()), v(system.length());
    system.packing().pack(body.x, x);
    system.packing().pack(body.v, v);
    system.kick_and_drift(x, v, 0.02, -0.03);
    system.packing().unpack(x, body.x);
    system.packing().unpack(v, body.v);
    body.x.insert(body.x.end(), body.v.begin(), body.v.end());
    return body.x;
}

/// A tangle or a web with a few fixed particles and two at the same point.
Body awkward_body(std::size_t particles, double damping) {
    Body body = particles == 0 ? bodies::ragged_web(damping) : bodies::tangle(particles, damping);
    body.network.fixed[0] = body.network.fixed[body.x.size() / 2] = 1;
    body.x[body.network.springs[5].a] = body.x[body.network.springs[5].b];
    return body;
}

}  // namespace

TEST_CASE("kernels and workers give the same bits", "[unit]") {
    struct Case {
        const char* name;
        std::size_t particles;
        double damping;
        double drag;
        bool external;
        bool bent = false;
    };
    // Counts that are and are not multiples of four; 4000 particles are enough to be shared.
    const Case cases[] = {{"a web", 0, 0.3, 0.1, true},
                          {"a bare web", 0, 0, 0, false},
                          {"a handful", 5, 0.3, 0.1, true},
                          {"bare springs", 101, 0, 0, false},
                          {"damped springs", 102, 0.3, 0, false},
                          {"drag and wind", 103, 0, 0.1, true},
                          {"many, bare", 4000, 0, 0, false},
                          {"many, everything", 4001, 0.3, 0.1, true},
                          {"a bent web", 0, 0.3, 0.1, true, true},
                          {"bent springs", 102, 0, 0, false, true}};
    for (const Case& each : cases) {
        INFO(each.name);
        Body body = awkward_body(each.particles, each.damping);
        if (each.bent) bodies::bend(body);
        std::vector<Vec3> wind;
        if (each.external) wind.assign(body.v.rbegin(), body.v.rend());
        const Surroundings around{{0, -9.81, 0}, each.drag, wind};
        const auto plain = accelerations_of(body, around, plain_kernels(), nullptr);
        TwoWorkers workers;
        CHECK(bodies::same_bits(plain, accelerations_of(body, around, plain_kernels(), &workers)));
        if (wide_kernels() != nullptr) {
            CHECK(bodies::same_bits(plain, accelerations_of(body, around, *wide_kernels(), nullptr)));
            CHECK(bodies::same_bits(plain, accelerations_of(body, around, *wide_kernels(), &workers)));
        }
        const auto moved = kicked(body, around, plain_kernels(), nullptr);
        CHECK(bodies::same_bits(moved, kicked(body, around, best_kernels(), nullptr)));
        CHECK(bodies::same_bits(moved, kicked(body, around, best_kernels(), &workers)));
        CHECK((workers.calls > 0) == (each.particles >= 4000));
        CHECK(plain[0] == Vec3{});
    }
}

TEST_CASE("a spring whose ends meet pulls nowhere", "[unit]") {
    Body body = bodies::oscillator(1, 10, 0.5);
    body.x[1] = body.x[0];
    body.v[1] = {1, 2, 3};
    for (const SpringKernels* kernels : {&plain_kernels(), &best_kernels()}) {
        CHECK(accelerations_of(body, {}, *kernels, nullptr)[1] == Vec3{});
    }
}

namespace {

/// A tangle whose rest lengths go to others, each by another share, through two steps.
struct Driven {
    Body body;
    SpringSystem system;
    std::vector<double> x, v;

    Driven(std::size_t particles, double damping, const SpringKernels& kernels, Workers* workers)
        : body(driven_body(particles, damping)),
          system(body.network, workers),
          x(system.length()),
          v(system.length()) {
        system.use_kernels(kernels);
        system.set_surroundings({{0, -9.81, 0}, 0.1, {}});
        for (std::size_t i = 0; i < body.network.springs.size(); ++i) {
            const double rest = body.network.springs[i].rest_length;
            system.set_rest_path(i, PathEnd::begin, rest);
            system.set_rest_path(i, PathEnd::end, end_of(i));
        }
        system.packing().pack(body.x, x);
        system.packing().pack(body.v, v);
        system.begin_rest_path(x, v);
        move(0.02);
    }
    double end_of(std::size_t spring) const {
        return body.network.springs[spring].rest_length * (1 + 0.01 * static_cast<double>(spring % 7));
    }
    /// On by h s.
    void move(double h) {
        for (std::size_t i = 0; i < body.x.size(); ++i) body.x[i] += h * body.v[i];
        system.packing().pack(body.x, x);
    }
    double length(std::size_t spring) const {
        const Spring& s = body.network.springs[spring];
        return distance(body.x[s.a], body.x[s.b]);
    }
    double rate(std::size_t spring) const {
        const Spring& s = body.network.springs[spring];
        return dot(body.x[s.a] - body.x[s.b], body.v[s.a] - body.v[s.b]) / length(spring);
    }

private:
    static Body driven_body(std::size_t particles, double damping) {
        Body body = bodies::tangle(particles, damping);
        body.network.driven = true;
        return body;
    }
};

}  // namespace

TEST_CASE("driving springs tells what it and damping did on the way of the step before", "[unit]") {
    const double lag = GENERATE(0.5, 0.0, -0.5);
    for (const double damping : {0.3, 0.0}) {
        Driven driven(57, damping, best_kernels(), nullptr);
        const std::size_t count = driven.body.network.springs.size();
        std::vector<double> length(count), rate(count), rest(count);
        driven.move(-0.02);  // to where the path began
        for (std::size_t i = 0; i < count; ++i) {
            length[i] = driven.length(i);
            rate[i] = driven.rate(i);
            rest[i] = driven.body.network.springs[i].rest_length;
        }
        driven.move(0.02);
        for (int step = 0; step < 3; ++step) {
            const double share = 0.2 + 0.4 * step;
            double work = 0, lost = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const Spring& s = driven.body.network.springs[i];
                const double before = rest[i], now = driven.rate(i), grown = driven.length(i) - length[i];
                rest[i] = s.rest_length + share * (driven.end_of(i) - s.rest_length);
                const double then = driven.length(i) - lag * grown;
                const auto energy = [&](double r) { return 0.5 * s.stiffness * (then - r) * (then - r); };
                work += energy(rest[i]) - energy(before);
                lost += s.damping * (rate[i] + now) / 2 * grown;
                length[i] = driven.length(i);
                rate[i] = now;
            }
            const DriveWork told = driven.system.drive(driven.x, driven.v, share, lag);
            CHECK(told.work == Approx(work).epsilon(1e-12));
            CHECK(told.damping == Approx(lost).epsilon(1e-12).margin(1e-300));
            for (std::size_t i = 0; i < count; ++i)
                CHECK(driven.system.rest_length(i) == Approx(rest[i]).epsilon(1e-15));
            driven.move(0.01);
        }
    }
}

TEST_CASE("driving springs leaves the pulls of where the step begins, and of nowhere else", "[unit]") {
    for (const double damping : {0.3, 0.0}) {
        Driven driven(57, damping, best_kernels(), nullptr);
        std::vector<double> first(driven.x.size()), anew(driven.x.size());
        driven.system.drive(driven.x, driven.v, 0.5, 0.5);
        driven.system.accelerations_at_start(driven.x, driven.v, first);
        driven.system.accelerations(driven.x, driven.v, anew);
        CHECK(first == anew);
        driven.move(0.1);
        driven.system.accelerations_at_start(driven.x, driven.v, first);
        CHECK(first != anew);
        driven.system.accelerations(driven.x, driven.v, anew);
        CHECK(first == anew);
        // Another evaluation in between, of what a method guesses, say.
        driven.system.drive(driven.x, driven.v, 1, 0.5);
        driven.move(0.1);
        driven.system.accelerations(driven.x, driven.v, anew);
        driven.system.accelerations_at_start(driven.x, driven.v, first);
        CHECK(first == anew);
    }
}

TEST_CASE("driving gives the same bits by every kernel and on any number of threads", "[unit]") {
    for (const std::size_t particles : {57U, 4001U}) {
        TwoWorkers workers;
        const auto driven_by = [&](const SpringKernels& kernels, Workers* shared) {
            Driven driven(particles, 0.3, kernels, shared);
            std::vector<double> all;
            for (const double share : {0.3, 1.0}) {
                const DriveWork told = driven.system.drive(driven.x, driven.v, share, 0.5);
                all.insert(all.end(), {told.work, told.damping});
                std::vector<double> a(driven.x.size());
                driven.system.accelerations_at_start(driven.x, driven.v, a);
                all.insert(all.end(), a.begin(), a.end());
                driven.move(0.01);
            }
            return all;
        };
        const std::vector<double> plain = driven_by(plain_kernels(), nullptr);
        CHECK(driven_by(best_kernels(), nullptr) == plain);
        CHECK(driven_by(best_kernels(), &workers) == plain);
        CHECK(driven_by(plain_kernels(), &workers) == plain);
        CHECK((workers.calls > 0) == (particles > 4000));
    }
}
