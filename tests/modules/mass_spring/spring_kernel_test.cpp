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
