// What peers take to bring a web through a second of wind as exactly as we do, in one process.
// Usage: peers FILE.json    (`tools/bench peers` builds and runs it)

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "contender.hpp"
#include "report.hpp"
#include "right_side.hpp"
#include "stopwatch.hpp"
#include "sweep.hpp"

namespace {

using namespace orbweaver;
using namespace orbweaver::peers;

constexpr double kPatience = 8;  // s, of one run

const Contender& find(const Contenders& all, const std::string& name, const std::string& right_side,
                      const std::string& knob) {
    for (const Contender& each : all)
        if (each.name == name && each.right_side == right_side && each.knob == knob) return each;
    throw std::logic_error("no contender is called " + name + " (" + right_side + ", " + knob + ")");
}

/// The least of several times, each taken in turn with the other's.
template <class Ours, class Theirs>
Comparison compare(std::string what, const Ours& ours, const Theirs& theirs) {
    constexpr int kRepeats = 10;
    Comparison result{std::move(what), ours(), theirs()};
    for (int i = 0; i < kRepeats; ++i) {
        result.ours = std::min(result.ours, ours());
        result.peers = std::min(result.peers, theirs());
    }
    return result;
}

/// s, of one evaluation.
double evaluation(const Problem& problem, MakeRightSide make) {
    constexpr int kCalls = 2000;
    const auto right_side = make(problem);
    std::vector<double> y(right_side->length()), rate(y.size());
    right_side->pack(problem, y.data());
    const Stopwatch watch;
    for (int i = 0; i < kCalls; ++i) right_side->evaluate(y.data(), rate.data());
    return watch.seconds() / kCalls;
}

Report compare_all(std::string name, const Problem& problem) {
    Contenders all = orbweaver_methods(problem);
    for (const auto& more : {odeint_methods(problem), cvode_methods(problem), bullet_methods(problem)})
        all.insert(all.end(), more.begin(), more.end());

    const Contender& our_rk4 = find(all, "orbweaver rk4", "orbweaver's", "step");
    const std::vector<Vec3> exact = our_rk4.run(1e-5).x;
    const std::vector<Vec3> again = find(all, "odeint dopri5", "plain", "tolerance").run(1e-12).x;
    Report report{std::move(name),
                  problem.x.size(),
                  problem.network.springs.size(),
                  largest_error(exact, problem.x),
                  largest_error(again, exact),
                  {},
                  {}};

    report.comparisons.push_back(compare(
        "one evaluation by the plain right side", [&] { return evaluation(problem, make_fast_right_side); },
        [&] { return evaluation(problem, make_plain_right_side); }));
    for (const char* right_side : {"plain", "orbweaver's"}) {
        const double step = 0.9 * our_rk4.first;
        const Contender& theirs = find(all, "odeint rk4", right_side, "step");
        report.comparisons.push_back(compare(
            std::string("odeint rk4 at the same step, right side ") + right_side,
            [&] { return our_rk4.run(step).seconds; }, [&] { return theirs.run(step).seconds; }));
    }
    for (const Contender& each : all) {
        std::cerr << each.name << ", " << each.right_side << ", by " << each.knob << '\n';
        report.sweeps.push_back(sweep(each, exact, kPatience));
    }
    return report;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::cerr << "peers: expected the name of a JSON file to write: peers FILE.json\n";
        return 2;
    }
    constexpr double kDamping = 1e-6;  // N s/m, the module's default
    const std::vector<Report> reports{compare_all("damped by air alone", web_in_wind(0)),
                                      compare_all("springs damped too", web_in_wind(kDamping))};
    for (const Report& report : reports) print(report, std::cout);
    write_json(reports, argv[1]);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "peers: " << error.what() << '\n';
    return 1;
}
