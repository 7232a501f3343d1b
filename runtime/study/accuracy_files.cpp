#include "study/accuracy_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/study_files.hpp"
#include "study/svg_plot.hpp"

namespace orbweaver::study {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: a figure that is not finite is written as null.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json positive(double value) { return value > 0 ? number(value) : Json(nullptr); }

/// s, the moment from which on statistics are taken.
double statistics_from(const AccuracyResult& result) {
    return static_cast<double>(result.conditioning.statistics_row()) * result.frame_s;
}

Json rung_json(const Rung& rung) {
    return {{"method", rung.method}, {"step_s", positive(rung.step)}, {"tolerance", positive(rung.tolerance)}};
}

Json deviation_json(const Deviation& deviation) {
    return {{"mean_energy_relative", number(deviation.energy)},
            {"mean_shape_m", number(deviation.shape_m)},
            {"spectrum_distance", number(deviation.spectrum)},
            {"frequency_relative", number(deviation.frequency)},
            {"power_relative", number(deviation.power)}};
}

Json row_json(const AccuracyRow& row) {
    Json json = rung_json(row.rung);
    json["error_m"] = row.error_m ? number(*row.error_m) : Json(nullptr);
    json["wall_s"] = row.wall_s;
    json["timed_runs"] = row.runs;
    json["steps"] = row.steps;
    json["outcome"] = row.outcome;
    if (row.deviation) json["statistics"] = deviation_json(*row.deviation);
    return json;
}

Json conditioning_json(const AccuracyResult& result) {
    const Conditioning& conditioning = result.conditioning;
    Json json = {{"displacement_m", kDisplacement},     {"run", rung_json(conditioning.rung)},
                 {"horizon_s", conditioning.horizon_s}, {"whole_run", conditioning.whole},
                 {"time_s", conditioning.time_s},       {"deviation_m", Json::array()}};
    for (const double d : conditioning.deviation_m) json["deviation_m"].push_back(number(d));
    json["statistics"] = deviation_json(result.twin);
    return json;
}

Json reference_json(const AccuracyResult& result) {
    Json json = rung_json(result.reference);
    json["confirmed_by"] = rung_json(result.second);
    json["confirmed_by"]["extrapolated"] = result.second_is_a_limit;
    json["uncertainty_m"] = number(result.uncertainty_m);
    json["statistics"] = {{"from_s", number(statistics_from(result))},
                          {"mean_energy_j", number(result.statistics.mean_energy_j)},
                          {"frequency_hz", number(result.statistics.frequency_hz)},
                          {"power_m2", number(result.statistics.power_m2)},
                          {"spectrum", result.statistics.spectrum}};
    return json;
}

bool on_front(const AccuracyResult& result, std::size_t row) {
    return std::find(result.front.begin(), result.front.end(), row) != result.front.end();
}

std::vector<std::string> methods_of(const AccuracyResult& result) {
    std::vector<std::string> methods;
    for (const AccuracyRow& row : result.rows)
        if (methods.empty() || methods.back() != row.rung.method) methods.push_back(row.rung.method);
    return methods;
}

SvgPlot error_plot(const AccuracyResult& result) {
    std::vector<double> costs;
    std::vector<double> errors;
    for (const AccuracyRow& row : result.rows) {
        if (!row.error_m) continue;
        costs.push_back(row.wall_s);
        errors.push_back(*row.error_m);
    }
    const std::string until =
        result.conditioning.whole ? "" : " up to " + seconds_text(result.conditioning.horizon_s);
    const Axis error_axis = axis_around(fmt::format("largest error{} / m", until), errors, true);
    SvgPlot plot(
        fmt::format("{}: error against run time, {} simulated", result.scene, seconds_text(result.duration_s)),
        axis_around("run time / s", costs, true), error_axis);
    std::vector<PlotPoint> front;
    for (const std::size_t i : result.front)
        front.push_back({result.rows[i].wall_s, result.rows[i].error_m.value_or(0)});
    plot.line(front, "#cccccc", false, 7);
    const auto methods = methods_of(result);
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::vector<PlotPoint> line;
        for (const AccuracyRow& row : result.rows)
            if (row.rung.method == methods[m] && row.error_m) line.push_back({row.wall_s, *row.error_m});
        plot.line(line, color_of(m));
        for (const AccuracyRow& row : result.rows)
            if (row.rung.method == methods[m] && row.error_m)
                plot.mark({row.wall_s, *row.error_m}, mark_of(m), color_of(m), row.outcome == "done");
        plot.legend_mark(methods[m] + (line.empty() ? ": none ended" : ""), mark_of(m), color_of(m));
    }
    plot.legend_line("Pareto front", "#cccccc");
    const auto is_hollow = [](const AccuracyRow& row) { return row.error_m && row.outcome != "done"; };
    if (std::any_of(result.rows.begin(), result.rows.end(), is_hollow))
        plot.legend_mark("hollow: not resolved", Mark::circle, "#666666", false);
    if (result.uncertainty_m >= error_axis.low) {
        const PlotPoint floor[] = {{0, result.uncertainty_m}, {HUGE_VAL, result.uncertainty_m}};
        plot.line(floor, "#666666", true, 1);
        plot.legend_line("reference's uncertainty", "#666666", true);
    }
    return plot;
}

SvgPlot conditioning_plot(const Conditioning& conditioning) {
    SvgPlot plot("Distance of a twin that began 1e-10 m away",
                 axis_around("time / s", conditioning.time_s, false),
                 axis_around("distance / m", conditioning.deviation_m, true), 790, 300);
    std::vector<PlotPoint> line;
    for (std::size_t i = 0; i < conditioning.time_s.size(); ++i)
        line.push_back({conditioning.time_s[i], conditioning.deviation_m[i]});
    plot.line(line, color_of(0));
    const PlotPoint horizon[] = {{conditioning.horizon_s, 0}, {conditioning.horizon_s, HUGE_VAL}};
    plot.line(horizon, "#666666", true);
    plot.legend_line("horizon", "#666666", true);
    return plot;
}

std::string size_text(const Rung& rung) {
    return rung.tolerance > 0 ? fmt::format("{:.3g} m", rung.tolerance) : seconds_text(rung.step);
}

std::string html_rows(const AccuracyResult& result) {
    std::string html =
        "<table><tr><th>method</th><th>step or tolerance</th><th>error / m</th><th>run time / s</th>"
        "<th>timed runs</th><th>steps</th><th>outcome</th></tr>\n";
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
        const AccuracyRow& row = result.rows[i];
        html += fmt::format(
            "<tr{}><td>{}</td><td>{}</td><td>{}</td><td>{:.3g}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            on_front(result, i) ? " class=\"front\"" : "", escaped(row.rung.method), size_text(row.rung),
            row.error_m ? fmt::format("{:.2e}", *row.error_m) : "", row.wall_s, row.runs, row.steps,
            row.outcome);
    }
    return html + "</table>\n";
}

std::string deviation_cells(const Deviation& deviation) {
    std::string html;
    for (const double value :
         {deviation.energy, deviation.shape_m, deviation.spectrum, deviation.frequency, deviation.power})
        html += std::isfinite(value) ? fmt::format("<td>{:.1e}</td>", value) : "<td>-</td>";
    return html;
}

std::string html_statistics(const AccuracyResult& result) {
    std::string html = fmt::format(
        "<table><tr><th>method</th><th>step or tolerance</th><th>mean energy</th><th>mean shape / m</th>"
        "<th>spectrum</th><th>frequency</th><th>power</th></tr>\n<tr class=\"front\"><td>the twin, {:g} m "
        "away</td><td>{}</td>{}</tr>\n",
        kDisplacement, size_text(result.conditioning.rung), deviation_cells(result.twin));
    for (const AccuracyRow& row : result.rows)
        if (row.deviation)
            html += fmt::format("<tr><td>{}</td><td>{}</td>{}</tr>\n", escaped(row.rung.method),
                                size_text(row.rung), deviation_cells(*row.deviation));
    return html + "</table>\n";
}

std::string reference_sentence(const AccuracyResult& result) {
    return fmt::format("reference: {}, confirmed by {}{} to {:.2g} m; the motion reaches {:.2g} m",
                       to_string(result.reference), to_string(result.second),
                       result.second_is_a_limit ? ", extrapolated to a step of 0," : "", result.uncertainty_m,
                       result.displacement_m);
}

constexpr const char* kHowToRead =
    "<p>Each mark is a run: how long its frames took, and the largest distance of any particle from the "
    "reference at the end of any frame up to the horizon. Lower left is better; the broad grey line joins the "
    "runs that no other one beats in both (bold in the table). Hollow marks lie within three times the "
    "reference's own "
    "uncertainty: their true error is at most about that. Run times are medians of as many runs as the table "
    "tells (of two their mean), fewer where a run is long; they leave out set-up and what the module spends on "
    "estimating its own error.</p>\n";

std::string how_statistics_read(const AccuracyResult& result) {
    return fmt::format(
        "<p>Differences from the reference, from {} to the end{}. Mean energy, strongest frequency and power "
        "are "
        "relative, the spectrum's is half the sum of all differences between shares of power (0: the same, 1: "
        "nothing in common); spectrum, frequency and power are those of the particle that moves most. The "
        "twin's "
        "are what a displacement at the start changes, so nothing smaller tells methods apart. -: not "
        "known.</p>\n",
        seconds_text(statistics_from(result)),
        result.conditioning.whole ? "" : ", beyond the horizon, where only these mean something");
}

std::string statistics_line(const std::string& method, const Rung& rung, const Deviation& deviation) {
    const auto known = [](double value, bool is_known) { return is_known ? fmt::format("{}", value) : ""; };
    std::string line = fmt::format("{},{},{}", method, known(rung.step, rung.step > 0),
                                   known(rung.tolerance, rung.tolerance > 0));
    for (const double value :
         {deviation.energy, deviation.shape_m, deviation.spectrum, deviation.frequency, deviation.power})
        line += "," + known(value, std::isfinite(value));
    return line + "\n";
}

}  // namespace

std::string accuracy_csv(const AccuracyResult& result) {
    std::string csv = "method,step_s,tolerance,error_m,wall_s,steps,outcome\n";
    for (const AccuracyRow& row : result.rows)
        csv +=
            fmt::format("{},{},{},{},{},{},{}\n", row.rung.method,
                        row.rung.step > 0 ? fmt::format("{}", row.rung.step) : "",
                        row.rung.tolerance > 0 ? fmt::format("{}", row.rung.tolerance) : "",
                        row.error_m ? fmt::format("{}", *row.error_m) : "", row.wall_s, row.steps, row.outcome);
    return csv;
}

std::string statistics_csv(const AccuracyResult& result) {
    std::string csv =
        "method,step_s,tolerance,mean_energy_relative,mean_shape_m,spectrum_distance,frequency_relative,"
        "power_relative\n" +
        statistics_line("twin", result.conditioning.rung, result.twin);
    for (const AccuracyRow& row : result.rows)
        if (row.deviation) csv += statistics_line(row.rung.method, row.rung, *row.deviation);
    return csv;
}

std::string accuracy_json(const AccuracyResult& result) {
    Json json = {{"scene", result.scene},           {"table", result.table},
                 {"duration_s", result.duration_s}, {"frame_s", result.frame_s},
                 {"particles", result.particles},   {"displacement_m", result.displacement_m}};
    json["conditioning"] = conditioning_json(result);
    json["reference"] = reference_json(result);
    json["rows"] = Json::array();
    for (const AccuracyRow& row : result.rows) json["rows"].push_back(row_json(row));
    json["pareto"] = result.front;
    json["sentences"] = accuracy_sentences(result);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string accuracy_svg(const AccuracyResult& result) { return error_plot(result).document(); }

std::string accuracy_page(const AccuracyResult& result) {
    std::string body = html_list(accuracy_sentences(result)) + error_plot(result).document() + kHowToRead;
    body += "<h2>Conditioning</h2>\n" + conditioning_plot(result.conditioning).document();
    body += "<h2>Every run</h2>\n" + html_rows(result);
    body += "<h2>Statistics</h2>\n" + how_statistics_read(result) + html_statistics(result);
    return html_page(fmt::format("{}: error against run time", result.scene), body);
}

std::vector<std::string> accuracy_sentences(const AccuracyResult& result) {
    std::vector<std::string> all{sentence(result.conditioning), reference_sentence(result)};
    all.insert(all.end(), result.sentences.begin(), result.sentences.end());
    return all;
}

}  // namespace orbweaver::study
