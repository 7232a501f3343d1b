#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "bodies.hpp"
#include "orbweaver/fault.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kTolerance = 1e-6;

/// What became of a run.
enum class Class : char {
    holds = 'H',
    substeps = 'S',  ///< holds after the step was shortened, with a warning
    obeyed = 'o',    ///< a step that is too long was taken as asked, with a warning, and stayed finite
    refused = 'R',   ///< before its first frame
    stopped = 'X',   ///< in a frame, of which the start is kept
};

/// Six spokes of three particles, the outermost fixed, and two rings; slightly taut. 0.2 ms is a stable step of
/// every method.
Body small_web() {
    constexpr std::uint32_t kSpokes = 6, kRings = 3;
    constexpr double kMass = 1e-6, kSpacing = 0.03, kRest = 0.028, kStiffness = 0.01, kDamping = 4e-5;
    Body body;
    body.add({0, 0, 0}, kMass);
    for (std::uint32_t spoke = 0; spoke < kSpokes; ++spoke) {
        const double angle = 2 * bodies::kPi * spoke / kSpokes;
        for (std::uint32_t ring = 1; ring <= kRings; ++ring) {
            const double r = kSpacing * ring;
            const auto i = body.add({r * std::cos(angle), r * std::sin(angle), 0}, kMass, ring == kRings);
            body.join(ring == 1 ? 0 : i - 1, i, kRest, kStiffness, kDamping);
            if (ring == kRings) continue;
            const std::uint32_t next = spoke + 1 < kSpokes ? i + kRings : ring;
            body.network.springs.push_back({i, next, kRest * ring, kStiffness, kDamping});
        }
    }
    return body;
}

using Change = std::function<void(Body&)>;

Change stiffness_times(double factor) {
    return [factor](Body& body) {
        for (Spring& s : body.network.springs) s.stiffness *= factor;
    };
}

Change rest_lengths_times(double factor) {
    return [factor](Body& body) {
        for (Spring& s : body.network.springs) s.rest_length *= factor;
    };
}

Change masses_of(double even, double odd) {
    return [even, odd](Body& body) {
        for (std::size_t i = 0; i < body.network.size(); ++i) body.network.mass[i] = i % 2 == 0 ? even : odd;
    };
}

/// Particle 2 moves to `way` from particle 1, to which a spring joins it.
Change ends_apart(const Vec3& way) {
    return [way](Body& body) { body.x[2] = body.x[1] + way; };
}

Change all_fixed(std::uint8_t fixed) {
    return [fixed](Body& body) {
        for (auto& each : body.network.fixed) each = fixed;
    };
}

void curve(Body& body) {
    for (Spring& s : body.network.springs)
        s.law = {3 / s.rest_length, 4 / (s.rest_length * s.rest_length), 0, 0};
}

/// In times far below, about and far above a step.
void relax_threads(Body& body) {
    double time = 1e-6;
    for (Spring& s : body.network.springs) {
        s.law = {0, 0, 5 * s.stiffness, time};
        time = time < 1 ? 10 * time : 1e-6;
    }
}

void leave_alone(Body&) {}

void leave_one(Body& body) {
    body = {};
    body.add({0, 0, 0}, 1e-6);
}

struct Case {
    const char* name;
    /// A letter of Class per method in the order of methods(), then per method that takes a tolerance.
    const char* substep;   ///< on_unstable = "substep"
    const char* as_asked;  ///< on_unstable = "as_asked", without those that take a tolerance
    Change change = leave_alone;
    double wind = 1e-6;  ///< N on every particle, across the web
    double step = 2e-4;  ///< s, asked
    int frames = 8;
    double frame = kFrame;    ///< s
    bool cut_spring = false;  ///< before the fifth frame
};

struct Column {
    const MethodInfo* method;
    double tolerance;
};

std::vector<Column> columns(OnUnstable policy) {
    std::vector<Column> all;
    for (const MethodInfo& method : methods()) all.push_back({&method, 0});
    if (policy == OnUnstable::as_asked) return all;
    for (const MethodInfo& method : methods())
        if (method.embedded_order > 0) all.push_back({&method, kTolerance});
    return all;
}

bool all_finite(const Body& body) {
    const auto finite = [](const Vec3& each) { return is_finite(each); };
    return std::all_of(body.x.begin(), body.x.end(), finite) &&
           std::all_of(body.v.begin(), body.v.end(), finite);
}

void check_sentence(const std::string& sentence, Class what) {
    const auto has = [&](const char* part) { return sentence.find(part) != std::string::npos; };
    INFO(sentence);
    CHECK((has(";") && has("step")));
    CHECK_FALSE(has("nan"));
    if (what != Class::stopped) return;
    CHECK(has("frame "));
    CHECK(has("t = "));
    CHECK((has("particle ") || has("errors of at most") || has("from nowhere")));
}

/// Runs a cell of the table, and checks what holds of every one: values are finite, energy comes from nowhere
/// only after a warning, and who stops keeps the frame's start.
Class run_cell(const Case& each, const Column& column, OnUnstable policy) {
    Body body = small_web();
    each.change(body);
    const std::vector<Vec3> wind(body.x.size(), Vec3{0, 0, each.wind});
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 1e-6, wind});

    SimulationSettings settings;
    settings.method = column.method;
    settings.tolerance = column.tolerance;
    if (column.tolerance == 0) settings.step = each.step;
    settings.on_unstable = policy;
    settings.max_substeps = 20000;  // so that the table takes seconds
    bool warned = false;
    settings.warn = [&](const std::string&) { warned = true; };

    std::vector<Vec3> x = body.x, v = body.v;
    double gain = 0, turnover = 0;
    Class what = Class::refused;
    try {
        Simulation run(system, settings, each.frame, body.x, body.v);
        what = Class::stopped;
        for (int i = 0; i < each.frames; ++i) {
            if (each.cut_spring && i == 4) {
                body.network.springs[1].stiffness = body.network.springs[1].damping = 0;
                run.network_changed();
            }
            x = body.x;
            v = body.v;
            const Energy before = system.energy(x, v);
            run.advance(static_cast<std::uint64_t>(i), i * each.frame);
            const EnergyBalance balance = balance_energy(system, before, x, body.x, body.v);
            gain += std::max(0.0, balance.gain - balance.rounding);
            turnover += balance.turnover;
        }
        what = !warned ? Class::holds : policy == OnUnstable::substep ? Class::substeps : Class::obeyed;
    } catch (const Fault& fault) {
        CHECK(fault.kind() == (body.network.springs[0].law.arm > 0 ? FaultKind::invalid : FaultKind::diverged));
        check_sentence(fault.what(), what);
        CHECK(bodies::same_bits(x, body.x));
        CHECK(bodies::same_bits(v, body.v));
    }
    CHECK(all_finite(body));
    if (what == Class::holds || what == Class::substeps)
        CHECK(gain <= 0.5 * turnover);  // as EnergyBalance has it
    return what;
}

std::string run_row(const Case& each, OnUnstable policy) {
    std::string row;
    for (const Column& column : columns(policy)) {
        INFO(each.name << ", " << column.method->name << (column.tolerance > 0 ? " within a tolerance" : ""));
        row += static_cast<char>(run_cell(each, column, policy));
        if (row.size() == methods().size() && policy == OnUnstable::substep) row += ' ';
    }
    return row;
}

}  // namespace

// One letter a method, as Class gives them:
//   e explicit_euler   s symplectic_euler   v verlet   r rk4   t tsit5   k rkc2   i implicit_euler   b tr_bdf2
//   p provot   x xpbd;   after the blank, within a tolerance of 1e-6 m a step: tsit5, rkc2, tr_bdf2.
TEST_CASE("every method holds, substeps, refuses or stops in words in every extreme case", "[extreme]") {
    const Vec3 nowhere{0, 0, 0}, hardly{1e-12, 0, 0};
    // clang-format off
    const Case cases[] = {
        // name, on_unstable = "substep", "as_asked"
        //                          esvrtkibpx tkb    esvrtkibpx
        {"as it is",            "HHHHHHHHHH HHH", "HHHHHHHHHH"},
        {"stiffness x 1e3",     "RHHHHSHHHS HHH", "XHHHHXHHHo", stiffness_times(1e3)},
        {"stiffness x 1e6",     "RSSSSRHHSS HXH", "XXXXXXHHXo", stiffness_times(1e6), 1e-6, 2e-4, 2},
        {"stiffness x 1e12",    "RRRRRRHHRX XXX", "XXXXXXHHXo", stiffness_times(1e12), 1e-6, 2e-4, 2},
        {"stiffness x 1e-6",    "HHHHHHHHHH HHH", "HHHHHHHHHH", stiffness_times(1e-6)},
        {"mass 1e-15 kg",       "RRRRRRHHRX XXH", "XXXXXXHHXo", masses_of(1e-15, 1e-15), 1e-6, 2e-4, 1},
        {"mass 1e3 kg",         "RHHHHHHHHH HHH", "oHHHHHHHHH", masses_of(1e3, 1e3)},
        {"masses 1e-15, 1e3 kg","RRRRRRHHRH XXH", "XXXXXXHHoH", masses_of(1e-15, 1e3), 1e-6, 2e-4, 1},
        {"ends that meet",      "HHHHHHHHHH HHH", "HHHHHHHHHH", ends_apart(nowhere)},
        {"ends 1e-12 m apart",  "HHHHHHHHHH HHH", "HHHHHHHHHH", ends_apart(hardly)},
        {"rest lengths of 0",   "SHHHHHHHHH HHH", "oHHHHHHHHH", rest_lengths_times(0)},
        {"in compression",      "HHHHHHHHHH HHH", "HHHHHHHHHH", rest_lengths_times(1.5)},
        {"rest lengths x 4",    "HHHHHHHHHH HHH", "HHHHHHHHHH", rest_lengths_times(4)},
        {"wind x 1e3",          "HHHHHHHHHH HHH", "HHHHHHHHHH", leave_alone, 1e-3},
        {"wind x 1e6",          "HHHHHHHHHH HHH", "HHHHHHHHHH", leave_alone, 1},
        {"step 1e-9 s",         "RRRRRRRRRR HHH", "RRRRRRRRRR", leave_alone, 1e-6, 1e-9},
        {"frames of 1e-9 s",    "HHHHHHHHHH HHH", "HHHHHHHHHH", leave_alone, 1e-6, 1e-9, 8, 1e-9},
        {"step 10 s",           "SSSSSSHHSS HHH", "ooooooHHoo", leave_alone, 1e-6, 10},
        {"frames of 10 s",      "RSSSSSHHSX HHH", "oXXXXXHHXo", leave_alone, 1e-6, 10, 2, 10},
        {"one particle",        "HHHHHHHHHH HHH", "HHHHHHHHHH", leave_one},
        {"everything fixed",    "HHHHHHHHHH HHH", "HHHHHHHHHH", all_fixed(1)},
        {"nothing fixed",       "HHHHHHHHHH HHH", "HHHHHHHHHH", all_fixed(0)},
        {"curved threads",      "HHHHHHHHHH HHH", "HHHHHHHHHH", curve},
        {"curved, wind x 1e3",  "HHHHHHHHXH HHH", "HHHHHHHHoH", curve, 1e-3},
        {"threads that relax",  "HHHHHHHHHH RRR", "HHHHHHHHHH", relax_threads},
        {"a spring is cut",     "SHHHHHHHHH HHH", "oHHHHHHHHH", leave_alone, 1e-6, 2e-4, 8, kFrame, true},
    };
    // clang-format on
    for (const Case& each : cases) {
        INFO(each.name);
        CHECK(run_row(each, OnUnstable::substep) == each.substep);
        CHECK(run_row(each, OnUnstable::as_asked) == each.as_asked);
    }
}
