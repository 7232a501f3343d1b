#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <functional>
#include <optional>

#include "crawling.hpp"
#include "mass_spring/run_error.hpp"
#include "orbweaver/fault.hpp"
#include "sanitized.hpp"
#include "shapes.hpp"
#include "spider/land.hpp"

using namespace orbweaver;
using namespace orbweaver::crawler;
using crawling::Run;
using crawling::Setup;
using mass_spring::OnUnstable;

namespace {

constexpr double kFrame = 1.0 / 60;
constexpr double kErrs = 0.1;  // of the motion: who is off by more does not hold
constexpr double kCrushed = 0.5;
constexpr double kRounding = 1e-12;  // m

/// What became of a run.
enum class Class : char {
    holds = 'H',     ///< and moves as at far finer steps
    substeps = 'S',  ///< holds after the step was shortened, with a warning
    errs = 'E',      ///< ends, with or without a warning, elsewhere; its error estimate says so
    crushed = 'C',   ///< has lost half of its volume, or is turned inside out, which max_volume_error says
    obeyed = 'o',    ///< a step that is too long was taken as asked, with a warning, and stayed finite
    refused = 'R',   ///< before its first frame
    stopped = 'X',   ///< in a frame, of which the start is kept
    silent = '!',    ///< ends elsewhere, and nothing says so
};

/// Every method of the manifest.
constexpr const char* kMethods[] = {"explicit_euler", "symplectic_euler", "verlet",  "rk4",    "tsit5",
                                    "rkc2",           "implicit_euler",   "tr_bdf2", "provot", "xpbd"};

/// A worm of 5 cm that crawls in great haste, and so gets somewhere in a few frames.
Setup worm() {
    Setup setup;
    setup.build.segments = 10;
    setup.build.length = 0.05;
    setup.build.width = 0.005;
    setup.make_springs(1.5, 0.9, 4e-3);
    setup.waves = 1;
    setup.period = 0.1;
    setup.effort.strain = 0.15;
    setup.friction = {FrictionLaw::coulomb, 0.1, 0.4, 0.3, 0};
    setup.step = 2e-4;
    setup.frame = kFrame;
    setup.max_substeps = 20000;  // so that the table takes seconds
    return setup;
}

using Change = std::function<void(Setup&)>;

void leave_alone(Setup&) {}
Change stiffness_times(double factor) {
    return [factor](Setup& setup) { setup.build.stiffness *= factor; };
}
Change damping_times(double factor) {
    return [factor](Setup& setup) { setup.build.damping *= factor; };
}
Change mass_times(double factor) {
    return [factor](Setup& setup) { setup.build.mass *= factor; };
}
Change friction_of(double coefficient) {
    return [coefficient](Setup& setup) {
        setup.friction.forward = setup.friction.backward = setup.friction.sideways = coefficient;
    };
}
void turn_over(Setup& setup) { setup.poses = {{{0, setup.build.width / 2, 0}, {1, 0, 0}, {0, -1, 0}}}; }
void slide_one_way(Setup& setup) { setup.friction.law = FrictionLaw::one_way; }
void beat(Setup& setup) { setup.form = WaveForm::square; }
void lift(Setup& setup) { setup.poses = {{{0, setup.build.width / 2 + 0.05, 0}, {1, 0, 0}, {0, 1, 0}}}; }

constexpr double kRoom = 0.2;  // m

/// In a corner of a room, its head at both walls.
void corner(Setup& setup) {
    static const land::Land room(mesh::room(kRoom, 2));
    const std::size_t points = std::size_t{kCorners} * (setup.build.segments + 1);
    setup.ground = SurfaceGround(room.surface(), points, setup.build.width, nullptr);
    const double off = kRoom / 2 - setup.build.width / 2 * std::sqrt(0.5),
                 half = setup.build.length / 2 * std::sqrt(0.5);
    const Vec3 forward = Vec3{1, 0, 1} * std::sqrt(0.5);
    setup.poses = {{{off - half, -kRoom / 2 + setup.build.width / 2, off - half}, forward, {0, 1, 0}}};
}

/// Far finer steps, to compare with.
struct Reference {
    const char* method = "symplectic_euler";
    double step = 1e-5;  ///< s
};
constexpr Reference kFine, kStiff{"symplectic_euler", 2e-6}, kStiffest{"verlet", 2e-7};

struct Case {
    const char* name;
    /// A letter of Class per method in the order of kMethods.
    const char* substep;   ///< on_unstable = "substep"
    const char* as_asked;  ///< on_unstable = "as_asked"
    Reference reference;
    Change change = leave_alone;
    int frames = 6;
    double step = 2e-4;     ///< s, asked
    double frame = kFrame;  ///< s
    Vec3 thrown{};          ///< m/s, at the start
    bool in_room = false;   ///< else on a floor
};

/// How a cell ended, and where.
struct Ending {
    Class what = Class::refused;
    std::vector<Vec3> x;        ///< m
    double error_estimate = 0;  ///< m
    double motion = 0;          ///< m, the longest way from the start that a frame ended at
    double volume_error = 0;    ///< at the end, of that at the start
    std::string said;
};

bool all_finite(std::span<const Vec3> of) {
    return std::all_of(of.begin(), of.end(), [](const Vec3& each) { return is_finite(each); });
}
bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
}
/// m, that a point is in a floor or a wall.
double deepest(const Case& each, std::span<const Vec3> of) {
    double most = -1;
    for (const Vec3& p : of)
        most = std::max(
            most, each.in_room ? std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - kRoom / 2 : -p.y);
    return most;
}
double farthest(std::span<const Vec3> a, std::span<const Vec3> b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, distance(a[i], b[i]));
    return most;
}

void check_sentence(const std::string& sentence, Class what) {
    const auto has = [&](const char* part) { return sentence.find(part) != std::string::npos; };
    INFO(sentence);
    CHECK((has(";") && has("step")));
    CHECK_FALSE(has("nan"));
    if (what == Class::stopped) CHECK((has("frame ") && has("t = ")));
}

/// Runs a case, and checks that values are finite, that nobody is in the floor, and that who stops keeps the
/// frame's start.
Ending run_case(const Case& each, const Setup& setup) {
    Ending ending;
    std::optional<Run> run;
    try {
        run.emplace(setup);
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::diverged);
        check_sentence(fault.what(), ending.what);
        ending.said = fault.what();
        return ending;
    }
    for (Vec3& v : run->v) v += each.thrown;
    const std::vector<Vec3> start = run->x;
    std::vector<Vec3> x, v, reaction;
    Books books;
    try {
        ending.what = Class::stopped;
        for (int i = 0; i < each.frames; ++i) {
            x = run->x, v = run->v, reaction = run->reaction, books = run->books();
            run->advance();
            ending.motion = std::max(ending.motion, farthest(run->x, start));
        }
        ending.error_estimate = run->error_estimate();
        ending.what = run->warnings == 0                         ? Class::holds
                      : setup.on_unstable == OnUnstable::substep ? Class::substeps
                                                                 : Class::obeyed;
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::diverged);
        check_sentence(fault.what(), ending.what);
        ending.said = fault.what();
        CHECK(same_bits(x, run->x));
        CHECK(same_bits(v, run->v));
        CHECK(same_bits(reaction, run->reaction));
        CHECK(books.muscles == run->books().muscles);
        CHECK(books.friction == run->books().friction);
    }
    CHECK(all_finite(run->x));
    CHECK(all_finite(run->v));
    CHECK(all_finite(run->reaction));
    CHECK(deepest(each, run->x) < setup.build.width);
    ending.x = run->x;
    const Lattice lattice{1, setup.build.segments};
    ending.volume_error = std::abs(volume(lattice, run->x) / volume(lattice, start) - 1);
    return ending;
}

Setup setup_of(const Case& each) {
    Setup setup = worm();
    setup.step = each.step;
    setup.frame = each.frame;
    each.change(setup);
    return setup;
}

Ending run_reference(const Case& each) {
    Setup setup = setup_of(each);
    setup.method = each.reference.method;
    setup.step = each.reference.step;
    setup.on_unstable = OnUnstable::stop;
    setup.max_substeps = 1000000;
    Ending ending = run_case(each, setup);
    INFO(ending.said);
    REQUIRE(ending.what == Class::holds);
    INFO("error " << ending.error_estimate << " m, motion " << ending.motion << " m");
    CHECK(ending.error_estimate <= 0.25 * ending.motion);
    return ending;
}

/// Moves what ends elsewhere than the reference to Class::errs, where its estimate owns to it.
Class judge(const Ending& ending, const Ending& reference) {
    if (ending.what != Class::holds && ending.what != Class::substeps) return ending.what;
    if (ending.volume_error > kCrushed) return Class::crushed;
    const double allowed = kErrs * reference.motion + kRounding;
    if (farthest(ending.x, reference.x) <= allowed) return ending.what;
    return ending.error_estimate > allowed ? Class::errs : Class::silent;
}

std::string run_row(const Case& each, OnUnstable policy, const Ending& reference) {
    std::string row;
    for (const char* method : kMethods) {
        INFO(each.name << ", " << method);
        Setup setup = setup_of(each);
        setup.method = method;
        setup.on_unstable = policy;
        const Ending ending = run_case(each, setup);
        row += static_cast<char>(judge(ending, reference));
    }
    return row;
}

}  // namespace

// One letter a method, as Class gives them:
//   e explicit_euler   s symplectic_euler   v verlet   r rk4   t tsit5
//   k rkc2   i implicit_euler   b tr_bdf2   p provot   x xpbd
TEST_CASE("crawlers hold, substep, refuse or stop in words in every extreme case, by every method",
          "[extreme]") {
    // clang-format off
    const Case cases[] = {
        // name, on_unstable = "substep", "as_asked"
        //                       esvrtkibpx    esvrtkibpx
        {"as it is",            "HHHHHHHHHH", "HHHHHHHHHH", kFine},
        {"stiffness x 1e3",     "SSSSSSHESH", "XXXXXXHEXH", kStiff, stiffness_times(1e3)},
        {"stiffness x 1e6",     "RSSSSREHSH", "XXXXXXEHXH", kStiffest, stiffness_times(1e6), 2},
        {"stiffness x 1e-3",    "HHHHHHHHEH", "HHHHHHHHEH", kFine, stiffness_times(1e-3)},
        {"damping x 1e3",       "SSSSSEEHSE", "XXXXXEEHXo", {"tr_bdf2", 1e-5}, damping_times(1e3), 3},
        {"damping x 1e6",       "RRRRREEERE", "XXXXXXEEXo", {"tr_bdf2", 2e-6}, damping_times(1e6), 2},
        {"mass x 1e-6",         "RRRRRSHHRE", "XXXXXXHHXE", {"tr_bdf2", 5e-6}, mass_times(1e-6), 2},
        {"mass x 1e3",          "CCCCCCCCCC", "CCCCCCCCCC", kFine, mass_times(1e3)},
        {"dropped from 10 m",   "CCCCCCCCCC", "CCCCCCCCCC", kFine, lift, 3, 2e-4, kFrame, {0, -13.97, 0}},
        {"dropped from 10 cm",  "HHHHHHHHHH", "HHHHHHHHHH", kFine, lift, 10, 2e-4, kFrame, {0, -0.99, 0}},
        {"upside down",         "HHHHHHHHHH", "HHHHHHHHHH", kFine, turn_over},
        {"pressed into a corner","HHHHHHHHHH", "HHHHHHHHHH", kFine, corner, 6, 2e-4, kFrame, {0.15, 0, 0.15}, true},
        {"friction 0",          "HHHHHHHHHH", "HHHHHHHHHH", kFine, friction_of(0)},
        {"friction 1e9",        "HHHHHHHHEH", "HHHHHHHHEH", kStiff, friction_of(1e9)},
        {"one_way",             "HHHHHHHHHH", "HHHHHHHHHH", kFine, slide_one_way},
        {"square waves",        "HHHHHHHHEH", "HHHHHHHHEH", kFine, beat},
        {"step 1 s",            "SSSSSSEESE", "oXXXXooooo", kFine, leave_alone, 6, 1},
        {"frames of 0.1 s",     "HHHHHHHHHH", "HHHHHHHHHH", kFine, leave_alone, 2, 2e-4, 0.1},
    };
    // clang-format on
    constexpr std::size_t kStride = kSanitized ? 8 : 1;
    for (std::size_t i = 0; i < std::size(cases); i += kStride) {
        const Case& each = cases[i];
        INFO(each.name);
        const Ending reference = run_reference(each);
        CHECK(run_row(each, OnUnstable::substep, reference) == each.substep);
        CHECK(run_row(each, OnUnstable::as_asked, reference) == each.as_asked);
    }
}
