#include "integrator.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

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

TEST_CASE("a step's error is what its method's order says, and of the size of what is wrong", "[unit]") {
    for (const MethodInfo& info : methods()) {
        if (info.embedded_order == 0) continue;
        INFO(info.name);
        std::vector<double> errors;
        for (const double h : {0.02, 0.01}) {
            bodies::Body body = bodies::oscillator(1, 9, 0.1);
            body.x[1].x = 1.5;
            body.v[1].x = 2;
            SpringSystem system(body.network, nullptr);
            std::vector<double> x(system.length()), v(system.length());
            system.packing().pack(body.x, x);
            system.packing().pack(body.v, v);
            const auto method = info.make(system.length());
            method->step(system, x, v, h);
            errors.push_back(method->error(system));
        }
        CHECK(std::log2(errors[0] / errors[1]) == Approx(info.embedded_order + 1).margin(0.15));
    }
}

TEST_CASE("a tighter tolerance is paid in steps and repaid in accuracy", "[unit]") {
    // q'' = -9 q from 0.5: q = 0.5 cos(3 t).
    for (const MethodInfo& info : methods()) {
        if (info.embedded_order == 0) continue;
        INFO(info.name);
        double before = 1;
        std::int64_t steps = 0;
        for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
            bodies::Body body = bodies::oscillator(1, 9);
            body.x[1].x = 1.5;
            SpringSystem system(body.network, nullptr);
            const ControlledRun run =
                Integrator(system, info).advance_within(body.x, body.v, 2, tolerance, 2, 1000000);
            REQUIRE(run.finished);
            const double wrong = std::abs(body.x[1].x - 1 - 0.5 * std::cos(6));
            CHECK(wrong < before / 5);
            CHECK(wrong < 10 * run.error);
            CHECK(run.steps > steps);
            before = wrong;
            steps = run.steps;
        }
    }
}

namespace {

/// Moves nothing, remembers its steps, and errs by as much each time.
class Recorder final : public Method {
public:
    static constexpr double kError = 1e-6;  // m
    static std::vector<double>& steps() {
        static std::vector<double> each;
        return each;
    }
    void step(DynamicSystem&, std::span<double>, std::span<double>, double h) override { steps().push_back(h); }
    double error(DynamicSystem&) override { return kError; }
    std::size_t memory_bytes() const noexcept override { return 0; }
};

}  // namespace

TEST_CASE("while a step has no reason to change, its bits do not either", "[unit]") {
    // An implicit method makes its matrix for one step to the last bit, and keeps it only for that.
    const MethodInfo info{"recorder", 2, 2, 1,
                          [](std::size_t) -> std::unique_ptr<Method> { return std::make_unique<Recorder>(); }};
    bodies::Body body = bodies::oscillator(1, 1);
    SpringSystem system(body.network, nullptr);
    for (const double first : {0.007, 0.013, 0.3, 1.0}) {
        Recorder::steps().clear();
        const ControlledRun run =
            Integrator(system, info).advance_within(body.x, body.v, 1, 2.1 * Recorder::kError, first, 1000);
        CHECK(run.finished);
        CHECK(run.next == first);
        const std::vector<double>& steps = Recorder::steps();
        CHECK(steps.size() == std::ceil(1 / first));
        CHECK(std::count(steps.begin(), steps.end(), steps.front()) == std::ssize(steps));
        CHECK(steps.front() * std::ceil(1 / first) == Approx(1).epsilon(1e-15));
    }
}

TEST_CASE("steps are taken from a budget, and end where it does", "[unit]") {
    for (const MethodInfo& info : methods()) {
        INFO(info.name);
        bodies::Body body = bodies::ragged_web(0.1);
        SpringSystem system(body.network, nullptr);
        Integrator integrator(system, info);
        StepBudget budget(7);
        CHECK(integrator.advance(body.x, body.v, 1e-3, 4, budget));
        CHECK(budget.taken() == 4);
        CHECK_FALSE(integrator.advance(body.x, body.v, 1e-3, 4, budget));
        CHECK(budget.taken() == 7);
        if (info.embedded_order == 0) continue;
        int asked = 0;
        const ControlledRun run =
            integrator.advance_within(body.x, body.v, 1, 1e-9, 1e-3, {1000000, [&] { return ++asked > 5; }});
        CHECK_FALSE(run.finished);
        CHECK(run.stopped);
        CHECK(run.steps == 5);
    }
}

TEST_CASE("steps that are too many end the run, not the program", "[extreme]") {
    bodies::Body body = bodies::oscillator(1e-6, 1e6);
    body.x[1].x = 1.5;
    SpringSystem system(body.network, nullptr);
    Integrator integrator(system, *find_method("tsit5"));
    const ControlledRun few = integrator.advance_within(body.x, body.v, 1, 1e-9, 1, 100);
    CHECK_FALSE(few.finished);
    CHECK(few.steps == 100);
    body.v[1].x = std::nan("");
    const ControlledRun none = integrator.advance_within(body.x, body.v, 1, 1e-9, 1, 1000000);
    CHECK_FALSE(none.finished);
    CHECK(none.next <= 1e-12);
}
