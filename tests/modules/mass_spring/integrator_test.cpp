#include "integrator.hpp"

#include <catch2/catch.hpp>

#include "bodies.hpp"

using namespace orbweaver;
using namespace orbweaver::mass_spring;

TEST_CASE("steps are the same one by one and all at once", "[unit]") {
    for (const MethodInfo& info : methods()) {
        INFO(info.name);
        const bool iterates = info.evaluations == 0;  // to a tolerance, with what it kept from the step before
        bodies::Body whole = bodies::ragged_web(0.1);
        bodies::Body single = whole;
        SpringSystem system(whole.network, nullptr);
        system.set_surroundings({{0, -9.81, 0}, 0.1, {}});
        Integrator(system, info).advance(whole.x, whole.v, 1e-3, 20);
        Integrator integrator(system, info);
        for (int i = 0; i < 20; ++i) integrator.advance(single.x, single.v, 1e-3, 1);
        for (std::size_t i = 0; iterates && i < whole.x.size(); ++i)
            CHECK(distance(whole.x[i], single.x[i]) < 1e-9);
        if (iterates) continue;
        CHECK(bodies::same_bits(whole.x, single.x));
        CHECK(bodies::same_bits(whole.v, single.v));
        CHECK(integrator.memory_bytes() >= 2 * system.length() * sizeof(double));
    }
}

TEST_CASE("external forces hold until others are set", "[unit]") {
    bodies::Body body;
    body.add({0, 0, 0}, 2);
    std::vector<Vec3> push{{6, 0, 0}};
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{}, 0, push});
    push[0] = {};  // the system has its own copy
    Integrator integrator(system, *find_method("rk4"));
    integrator.advance(body.x, body.v, 0.5, 2);
    CHECK(body.v[0].x == Approx(3).epsilon(1e-14));
    system.set_surroundings({});
    integrator.advance(body.x, body.v, 0.5, 2);
    CHECK(body.v[0].x == Approx(3).epsilon(1e-14));
}
