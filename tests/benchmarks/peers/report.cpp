#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>

namespace orbweaver::peers {
namespace {

std::string cell(const std::optional<Point>& point, double ours) {
    return point ? fmt::format("{:.3g} s, {:.2f}", point->seconds, point->seconds / ours) : "-";
}

nlohmann::json to_json(const Point& point) {
    return {{"setting", point.setting}, {"error_m", point.error}, {"seconds", point.seconds}};
}

nlohmann::json to_json(const Sweep& sweep, const Report& report) {
    nlohmann::json json{{"name", sweep.contender.name},
                        {"right_side", sweep.contender.right_side},
                        {"knob", sweep.contender.knob},
                        {"ours", sweep.contender.ours}};
    for (const Point& point : sweep.points) json["runs"].push_back(to_json(point));
    for (std::size_t i = 0; i < kTargets.size(); ++i) {
        if (!sweep.cheapest[i]) continue;
        nlohmann::json best = to_json(*sweep.cheapest[i]);
        best["target_m"] = kTargets[i];
        best["times_ours"] = sweep.cheapest[i]->seconds / report.our_seconds(i);
        json["cheapest"].push_back(best);
    }
    return json;
}

nlohmann::json to_json(const Report& report) {
    nlohmann::json json{{"problem", report.problem},
                        {"particles", report.particles},
                        {"springs", report.springs},
                        {"moved_m", report.moved},
                        {"reference_doubt_m", report.doubt}};
    for (const Comparison& c : report.comparisons)
        json["comparisons"].push_back(
            {{"what", c.what}, {"our_seconds", c.ours}, {"peer_seconds", c.peers}, {"ratio", c.ratio()}});
    for (const Sweep& sweep : report.sweeps) json["contenders"].push_back(to_json(sweep, report));
    return json;
}

}  // namespace

double Report::our_seconds(std::size_t target) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Sweep& sweep : sweeps)
        if (sweep.contender.ours && sweep.cheapest[target])
            least = std::min(least, sweep.cheapest[target]->seconds);
    return least;
}

void print(const Report& report, std::ostream& out) {
    out << fmt::format(
        "\n{}: {} particles, {} springs, 1 s of wind; the farthest moves by {:.3g} m; two references "
        "differ by {:.2g} m\n\n",
        report.problem, report.particles, report.springs, report.moved, report.doubt);
    for (const Comparison& c : report.comparisons)
        out << fmt::format("{}: {:.4g} s against our {:.4g} s, {:.2f} times\n", c.what, c.peers, c.ours,
                           c.ratio());
    out << "\n| integrator | forces | knob | within 0.1 mm | within 1 um | within 10 nm | least error |\n"
           "|---|---|---|---|---|---|---|\n";
    for (const Sweep& sweep : report.sweeps) {
        const Contender& c = sweep.contender;
        out << fmt::format("| {} | {} | {} |", c.name, c.right_side, c.knob);
        for (std::size_t i = 0; i < kTargets.size(); ++i)
            out << fmt::format(" {} |", cell(sweep.cheapest[i], report.our_seconds(i)));
        const Point best = sweep.most_accurate();
        out << fmt::format(" {:.2g} m in {:.3g} s |\n", best.error, best.seconds);
    }
}

void write_json(const std::vector<Report>& reports, const std::string& path) {
    nlohmann::json json;
    for (const Report& report : reports) json.push_back(to_json(report));
    std::ofstream file(path);
    file << json.dump(1) << '\n';
    file.close();
    if (!file)
        throw std::runtime_error("'" + path + "' could not be written; is its folder there, and room in it?");
}

}  // namespace orbweaver::peers
