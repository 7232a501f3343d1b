#include "study/stability_files.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "study/study_files.hpp"
#include "study/svg_plot.hpp"

namespace orbweaver::study {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 5> kColors = {"#56b4e9", "#f0c94a", "#d55e00", "#444444", "#eeeeee"};

/// The lines between cells: halfway between their values, and as far beyond the outer ones.
std::vector<double> borders(const MapAxis& axis) {
    const auto& v = axis.values;
    const auto between = [&](double a, double b) { return axis.log ? std::sqrt(a * b) : (a + b) / 2; };
    const auto beyond = [&](double a, double b) { return axis.log ? b * std::sqrt(b / a) : b + (b - a) / 2; };
    std::vector<double> all{beyond(v[1], v[0])};
    for (std::size_t i = 1; i < v.size(); ++i) all.push_back(between(v[i - 1], v[i]));
    all.push_back(beyond(v[v.size() - 2], v.back()));
    return all;
}

Axis plot_axis(const MapAxis& axis) {
    const auto ends = borders(axis);
    return {axis.unit == "1" ? axis.path : axis.path + " / " + axis.unit, ends.front(), ends.back(), axis.log};
}

/// A step and a value of the other axis, as a point of the map.
PlotPoint at_step(const StabilityResult& result, double step, double other) {
    return result.axes.step_axis == 0 ? PlotPoint{step, other} : PlotPoint{other, step};
}

bool within(const Axis& axis, double value) { return value >= axis.low && value <= axis.high; }

void draw_advice(SvgPlot& plot, const StabilityResult& result, const StabilityMap& map) {
    if (map.advised_s.empty()) return;
    const MapAxis& other = result.axes.other();
    const Axis step = plot_axis(result.axes.step_axis == 0 ? result.axes.x : result.axes.y);
    bool crosses = false;
    for (std::size_t i = 1; i < other.values.size(); ++i) {
        if (!within(step, map.advised_s[i - 1]) && !within(step, map.advised_s[i])) continue;
        const PlotPoint part[] = {at_step(result, map.advised_s[i - 1], other.values[i - 1]),
                                  at_step(result, map.advised_s[i], other.values[i])};
        plot.line(part, "#000000", false, 2.4);
        crosses = true;
    }
    if (crosses)
        plot.legend_line("advised limit", "#000000");
    else
        plot.legend_line(map.advised_s.front() > step.high ? "advised: any of these" : "advised: none of these",
                         "none");
}

void draw_own_point(SvgPlot& plot, const StabilityResult& result, const StabilityMap& map) {
    PlotPoint point{result.axes.x.own.value_or(NAN), result.axes.y.own.value_or(NAN)};
    if (result.axes.step_axis >= 0 && map.own_step_s)
        point = at_step(result, *map.own_step_s, result.axes.step_axis == 0 ? point.y : point.x);
    if (std::isnan(point.x) || std::isnan(point.y)) return;
    const bool inside = within(plot_axis(result.axes.x), point.x) && within(plot_axis(result.axes.y), point.y);
    if (!inside) return;
    plot.mark(point, Mark::diamond, "#000000", false, 6);
    plot.legend_mark("the scene as it is", Mark::diamond, "#000000", false);
}

SvgPlot draw_map(const StabilityResult& result, const StabilityMap& map) {
    SvgPlot plot(fmt::format("{}, {}", result.scene, map.method), plot_axis(result.axes.x),
                 plot_axis(result.axes.y), 650, 400);
    const auto x = borders(result.axes.x);
    const auto y = borders(result.axes.y);
    std::array<bool, kColors.size()> seen{};
    for (std::size_t i = 0; i < map.cells.size(); ++i) {
        const std::size_t column = i % result.axes.columns();
        const std::size_t row = i / result.axes.columns();
        const auto kind = static_cast<std::size_t>(map.cells[i]);
        plot.cell({x[column], y[row]}, {x[column + 1], y[row + 1]}, kColors[kind]);
        seen[kind] = true;
    }
    for (std::size_t kind = 0; kind < seen.size(); ++kind)
        if (seen[kind]) plot.legend_cell(to_string(static_cast<CellClass>(kind)), kColors[kind]);
    draw_advice(plot, result, map);
    draw_own_point(plot, result, map);
    return plot;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json axis_json(const MapAxis& axis) {
    return {{"path", axis.path},
            {"unit", axis.unit},
            {"values", axis.values},
            {"logarithmic", axis.log},
            {"scene", axis.own ? number(*axis.own) : Json(nullptr)}};
}

Json map_json(const StabilityMap& map) {
    Json json = {{"method", map.method}, {"classes", Json::array()}, {"advised_step_s", Json::array()}};
    for (const CellClass kind : map.cells) json["classes"].push_back(to_string(kind));
    for (const double step : map.advised_s) json["advised_step_s"].push_back(number(step));
    json["scene_step_s"] = map.own_step_s ? number(*map.own_step_s) : Json(nullptr);
    return json;
}

std::string how_to_read(const StabilityResult& result) {
    return fmt::format(
        "<p>Each cell is a run of {}. <b>diverged</b>: it ended early, with values that mean nothing. "
        "<b>degraded</b>: it ended, but moved more than {:g} times faster or slower (root mean square speed "
        "between "
        "frames) than the same physics at a stable step. <b>stable</b>: it moved like that. <b>refused</b>: "
        "the "
        "module would not begin. <b>unknown</b>: there was no time for it or for its reference. The line is "
        "the "
        "longest step that the adviser holds for stable, found without running; the diamond is the scene as it "
        "stands, at the step it would take.</p>\n",
        seconds_text(result.duration_s), kSpeedFactor);
}

}  // namespace

std::string stability_csv(const StabilityResult& result) {
    std::string csv = fmt::format("method,{},{},class\n", result.axes.x.path, result.axes.y.path);
    for (const StabilityMap& map : result.maps)
        for (std::size_t i = 0; i < map.cells.size(); ++i)
            csv += fmt::format("{},{},{},{}\n", map.method, result.axes.x_of(i), result.axes.y_of(i),
                               to_string(map.cells[i]));
    return csv;
}

std::string stability_json(const StabilityResult& result) {
    Json json = {{"scene", result.scene},
                 {"table", result.table},
                 {"duration_s", result.duration_s},
                 {"axes", {axis_json(result.axes.x), axis_json(result.axes.y)}},
                 {"maps", Json::array()}};
    for (const StabilityMap& map : result.maps) json["maps"].push_back(map_json(map));
    json["sentences"] = result.sentences;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string stability_svg(const StabilityResult& result) {
    std::vector<SvgPlot> plots;
    for (const StabilityMap& map : result.maps) plots.push_back(draw_map(result, map));
    return svg_grid(plots, 2);
}

std::string stability_page(const StabilityResult& result) {
    return html_page(fmt::format("{}: where each method holds", result.scene),
                     html_list(result.sentences) + stability_svg(result) + how_to_read(result));
}

}  // namespace orbweaver::study
