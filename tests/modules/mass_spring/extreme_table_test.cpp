#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "bodies.hpp"
#include "orbweaver/fault.hpp"
#include "sanitized.hpp"
#include "simulation.hpp"

using bodies::Body;
using namespace orbweaver;
using namespace orbweaver::mass_spring;

namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kTolerance = 1e-6;  // m, of a step
constexpr double kErrs = 0.1;        // of the motion: who is off by more does not hold
constexpr double kRounding = 5e-16;  // m: some last places of a coordinate of 0.09 m

/// What became of a run.
enum class Class : char {
    holds = 'H',     ///< and moves as the equations say
    substeps = 'S',  ///< holds after the step was shortened, with a warning
    errs =
        'E',  ///< ends, with or without a warning, elsewhere than the equations say; its error estimate says so
    obeyed = 'o',   ///< a step that is too long was taken as asked, with a warning, and stayed finite
    refused = 'R',  ///< before its first frame
    stopped = 'X',  ///< in a frame, of which the start is kept
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

/// The equations' own motion, to compare with: by a method of order four or of implicit order two at steps that
/// leave errors far below what is asked of the cells.
struct Reference {
    const char* method = "rk4";
    double step = 1e-5;  ///< s; 0: out of reach of every method
    /// Stiff, buckling, or of few steps: methods of every order are asked for the same.
    bool rough = false;
    /// Undamped, particles fly past each other closely, and err in that one frame, which may not be sampled.
    bool near_misses = false;
};
constexpr Reference kSmooth, kRough{"rk4", 1e-5, true}, kNone{"rk4", 0, true},
    kThrown{"rk4", 1e-5, false, true};

struct Case {
    const char* name;
    /// A letter of Class per method in the order of methods(), then per method that takes a tolerance.
    const char* substep;   ///< on_unstable = "substep"
    const char* as_asked;  ///< on_unstable = "as_asked", without those that take a tolerance
    Reference reference;
    Change change = leave_alone;
    double wind = 1e-6;     ///< N on every particle, across the web
    double step = 2e-4;     ///< s, asked
    double frame = kFrame;  ///< s
    int frames = 8;
    bool cut_spring = false;  ///< before the fifth frame
    bool buckles = false;     ///< what errors become is not the sum of single frames'
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

/// How a cell ended, and where.
struct Ending {
    Class what = Class::refused;
    std::vector<Vec3> x;            ///< m
    double error_estimate = 0;      ///< m
    double motion = 0;              ///< m, the longest way from the start that a frame ended at
    double gain = 0, turnover = 0;  ///< J, see EnergyBalance
};

SimulationSettings settings_of(const Case& each, const Column& column, OnUnstable policy) {
    SimulationSettings settings;
    settings.method = column.method;
    settings.tolerance = column.tolerance;
    if (column.tolerance == 0) settings.step = each.step;
    settings.on_unstable = policy;
    settings.max_substeps = 20000;  // so that the table takes seconds
    return settings;
}

/// Whether the springs of a case keep their damping.
enum class Springs : std::uint8_t { damped, undamped };

/// Runs a case, and checks that values are finite and that who stops keeps the frame's start.
Ending run_case(const Case& each, Springs springs, SimulationSettings settings) {
    Body body = small_web();
    each.change(body);
    if (springs == Springs::undamped)
        for (Spring& s : body.network.springs) s.damping = 0;
    const std::vector<Vec3> start = body.x, wind(body.x.size(), Vec3{0, 0, each.wind});
    SpringSystem system(body.network, nullptr);
    system.set_surroundings({{0, -9.81, 0}, 1e-6, wind});
    bool warned = false;
    settings.warn = [&](const std::string&) { warned = true; };
    std::vector<Vec3> x = body.x, v = body.v;
    Ending ending;
    try {
        Simulation run(system, settings, each.frame, body.x, body.v);
        ending.what = Class::stopped;
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
            ending.gain += std::max(0.0, balance.gain - balance.rounding);
            ending.turnover += balance.turnover;
            ending.motion = std::max(ending.motion, largest_distance(body.x, start));
        }
        ending.error_estimate = run.error_estimate();
        ending.what = !warned                                       ? Class::holds
                      : settings.on_unstable == OnUnstable::substep ? Class::substeps
                                                                    : Class::obeyed;
    } catch (const Fault& fault) {
        CHECK(fault.kind() == (body.network.springs[0].law.arm > 0 ? FaultKind::invalid : FaultKind::diverged));
        check_sentence(fault.what(), ending.what);
        CHECK(bodies::same_bits(x, body.x));
        CHECK(bodies::same_bits(v, body.v));
    }
    CHECK(all_finite(body));
    ending.x = body.x;
    return ending;
}

/// Nothing where no method reaches it.
std::optional<Ending> run_reference(const Case& each, Springs springs) {
    if (each.reference.step == 0) return std::nullopt;
    SimulationSettings settings;
    settings.method = find_method(each.reference.method);
    settings.step = each.reference.step;
    settings.on_unstable = OnUnstable::stop;
    settings.max_substeps = 1000000;
    Ending ending = run_case(each, springs, settings);
    REQUIRE(ending.what == Class::holds);
    CHECK(ending.error_estimate <= 2e-3 * ending.motion + kRounding);
    return ending;
}

/// Of the motion: what a method may be off by where the web moves smoothly, and where not.
double share_allowed(const Case& each, const Column& column, Class what) {
    if (each.reference.rough || what == Class::substeps) return kErrs;
    if (column.tolerance > 0) return 2e-3;
    if (column.method->undamped && each.reference.near_misses) return 2e-4;
    return column.method->order >= 4 ? 1e-7 : column.method->order == 2 ? 5e-5 : 0.02;
}

/// Moves what ends elsewhere than the reference to Class::errs, and checks that the estimate tells errors:
/// never less than a fourth of what they are, nor, where they are as large as the motion, less than a tenth of
/// that.
Class judge(const Case& each, const Column& column, const Ending& ending,
            const std::optional<Ending>& reference) {
    if (ending.what != Class::holds && ending.what != Class::substeps) return ending.what;
    CHECK(ending.gain <= 0.5 * ending.turnover);  // as EnergyBalance has it
    const double motion = reference ? reference->motion : ending.motion;
    const double error = reference ? largest_distance(ending.x, reference->x) : motion;
    INFO("error " << error << " m, estimate " << ending.error_estimate << " m, motion " << motion << " m");
    if (error > kErrs * motion + kRounding) {
        CHECK(ending.error_estimate > kErrs * motion);
        return Class::errs;
    }
    CHECK(error <= share_allowed(each, column, ending.what) * motion + kRounding);
    // A method of order six comes nearer than the reference, with its thousands of steps to round.
    const double doubt =
        column.method->order == 6 && reference ? reference->error_estimate + 2e-13 * motion : 0;
    const bool adds_up = !each.buckles && !(column.method->undamped && each.reference.near_misses);
    if (adds_up) CHECK(error <= 4 * ending.error_estimate + doubt + kRounding);
    return ending.what;
}

/// Of a case whose springs are damped, and not.
struct References {
    explicit References(const Case& each)
        : damped(run_reference(each, Springs::damped)), undamped(run_reference(each, Springs::undamped)) {}
    std::optional<Ending> damped, undamped;
};

std::string run_row(const Case& each, OnUnstable policy, const References& references) {
    std::string row;
    for (const Column& column : columns(policy)) {
        INFO(each.name << ", " << column.method->name << (column.tolerance > 0 ? " within a tolerance" : ""));
        const Springs springs = column.method->undamped ? Springs::undamped : Springs::damped;
        const Ending ending = run_case(each, springs, settings_of(each, column, policy));
        row += static_cast<char>(
            judge(each, column, ending, column.method->undamped ? references.undamped : references.damped));
        if (row.size() == methods().size() && policy == OnUnstable::substep) row += ' ';
    }
    return row;
}

}  // namespace

// One letter a method, as Class gives them:
//   e explicit_euler   s symplectic_euler   v verlet   r rk4   t tsit5   n srkn6, of springs without damping
//   k rkc2   i implicit_euler   b tr_bdf2   p provot   x xpbd;   after the blank, within a tolerance of 1e-6 m
//   a step: tsit5, rkc2, tr_bdf2.
TEST_CASE("every method holds, substeps, refuses or stops in words in every extreme case", "[extreme]") {
    const Vec3 nowhere{0, 0, 0}, hardly{1e-12, 0, 0};
    // clang-format off
    const Case cases[] = {
        // name, on_unstable = "substep", "as_asked"
        //                          esvrtnkibpx tkb    esvrtnkibpx
        {"as it is",            "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kSmooth},
        {"stiffness x 1e3",     "RHHHHHSHHES HHH", "XHHHHHXHHEo", {"rk4", 2e-6, true}, stiffness_times(1e3)},
        {"stiffness x 1e6",     "RESSSSRHHEE EXE", "XXXXXXXHHXo", {"rk4", 1e-7, true}, stiffness_times(1e6), 1e-6, 2e-4, kFrame, 2},
        {"stiffness x 1e12",    "RRRRRRREERX XXX", "XXXXXXXEEXo", kNone, stiffness_times(1e12), 1e-6, 2e-4, kFrame, 2},
        {"stiffness x 1e-6",    "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kSmooth, stiffness_times(1e-6)},
        {"mass 1e-15 kg",       "RRRRRRRHHRX XXH", "XXXXXXXHHXo", {"tr_bdf2", 2.5e-6}, masses_of(1e-15, 1e-15), 1e-6, 2e-4, kFrame, 1},
        {"mass 1e3 kg",         "RHHHHHHHHEH HHH", "oHHHHHHHHEH", kSmooth, masses_of(1e3, 1e3)},
        {"masses 1e-15, 1e3 kg","RRRRRRRHHRE XXH", "XXXXXXXHHoE", {"tr_bdf2", 2.5e-6}, masses_of(1e-15, 1e3), 1e-6, 2e-4, kFrame, 1},
        {"ends that meet",      "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kRough, ends_apart(nowhere), 1e-6, 2e-4, kFrame, 8, false, true},
        {"ends 1e-12 m apart",  "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kThrown, ends_apart(hardly)},
        {"rest lengths of 0",   "SHHHHHHHHHH HHH", "oHHHHHHHHHH", kSmooth, rest_lengths_times(0)},
        {"in compression",      "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kSmooth, rest_lengths_times(1.5)},
        {"rest lengths x 4",    "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kRough, rest_lengths_times(4), 1e-6, 2e-4, kFrame, 8, false, true},
        {"wind x 1e3",          "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kSmooth, leave_alone, 1e-3},
        {"wind x 1e6",          "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kThrown, leave_alone, 1},
        {"step 1e-9 s",         "RRRRRRRRRRR HHH", "RRRRRRRRRRR", kSmooth, leave_alone, 1e-6, 1e-9},
        {"frames of 1e-9 s",    "HHHHHHHHHHH HHH", "HHHHHHHHHHH", {"rk4", 1e-10}, leave_alone, 1e-6, 1e-9, 1e-9},
        {"step 10 s",           "SSSSSSSEHEE HHH", "oooooooEHoo", kRough, leave_alone, 1e-6, 10},
        {"frames of 10 s",      "RSSSSSSEHEX HHH", "oXXXXXXEHXo", {"rk4", 1e-4, true}, leave_alone, 1e-6, 10, 10, 2},
        {"one particle",        "HHHHHHHHHHH HHH", "HHHHHHHHHHH", kSmooth, leave_one},
        {"everything fixed",    "HHHHHHHHHHH HHH", "HHHHHHHHHHH", kSmooth, all_fixed(1)},
        {"nothing fixed",       "HHHHHHHHHHH HHH", "HHHHHHHHHHH", kSmooth, all_fixed(0)},
        {"curved threads",      "HHHHHHHHHEH HHH", "HHHHHHHHHEH", kSmooth, curve},
        {"curved, wind x 1e3",  "EHHHHHHHHXH HHH", "EHHHHHHHHoH", kRough, curve, 1e-3},
        {"threads that relax",  "HHHHHHHHHEH RRR", "HHHHHHHHHEH", kRough, relax_threads},
        {"a spring is cut",     "SHHHHHHHHEH HHH", "oHHHHHHHHEH", kSmooth, leave_alone, 1e-6, 2e-4, kFrame, 8, true},
    };
    // clang-format on
    constexpr std::size_t kStride = kSanitized ? 3 : 1;
    for (std::size_t i = 0; i < std::size(cases); i += kStride) {
        const Case& each = cases[i];
        INFO(each.name);
        const References references(each);
        CHECK(run_row(each, OnUnstable::substep, references) == each.substep);
        CHECK(run_row(each, OnUnstable::as_asked, references) == each.as_asked);
    }
}
