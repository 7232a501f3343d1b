#include "study/stability_files.hpp"

#include <fmt/format.h>

#include <algorithm>
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
    const bool plain = axis.labelled() || axis.unit == "1";
    return {plain ? axis.path : axis.path + " / " + axis.unit, ends.front(), ends.back(), axis.log,
            axis.labels};
}

/// A step and a value of the other axis, as a point of the map.
PlotPoint at_step(const StabilityResult& result, double step, double other) {
    return result.axes.step_axis == 0 ? PlotPoint{step, other} : PlotPoint{other, step};
}

bool within(const Axis& axis, double value) { return value >= axis.low && value <= axis.high; }

/// As much of the adviser's limit as is longer than 0 and not infinite, across labelled cells as steps.
void draw_advice(SvgPlot& plot, const StabilityResult& result, const StabilityMap& map) {
    if (map.advised_s.empty()) return;
    const MapAxis& other = result.axes.other();
    const Axis step = plot_axis(result.axes.step_axis == 0 ? result.axes.x : result.axes.y);
    const auto edges = borders(other);
    std::vector<PlotPoint> limit;
    for (std::size_t i = 0; i < other.values.size(); ++i) {
        const double advised = map.advised_s[i];
        const double drawn = advised > 0 && std::isfinite(advised) ? advised : NAN;
        if (other.labelled()) limit.push_back(at_step(result, drawn, edges[i]));
        limit.push_back(at_step(result, drawn, other.labelled() ? edges[i + 1] : other.values[i]));
    }
    plot.line(limit, "#000000", false, 2.4);
    if (std::any_of(map.advised_s.begin(), map.advised_s.end(), [&](double s) { return within(step, s); }))
        plot.legend_line("adviser: longest stable step", "#000000");
    else
        plot.legend_text(map.advised_s.front() > step.high ? "adviser: all of these are stable"
                                                           : "adviser: none of these is stable");
}

/// A mark at the scene's own value of the other axis and this step, told of even where it is not on the map.
void draw_step(SvgPlot& plot, const StabilityResult& result, const std::string& what, double step, Mark mark,
               bool filled, double size) {
    const PlotPoint point = at_step(result, step, result.axes.other().own.value_or(NAN));
    const bool inside = within(plot_axis(result.axes.x), point.x) && within(plot_axis(result.axes.y), point.y);
    const std::string text = fmt::format("{}: {}", what, seconds_text(step));
    if (!inside) return plot.legend_text(text + " (off this map)");
    plot.mark(point, mark, "#000000", filled, size);
    plot.legend_mark(text, mark, "#000000", filled);
}

/// The scene's own point: at the step it asks for and at the one it takes, where a step is mapped.
void draw_own_points(SvgPlot& plot, const StabilityResult& result, const StabilityMap& map) {
    if (result.axes.step_axis >= 0) {
        draw_step(plot, result, "scene asks for", result.asked_step_s, Mark::square, false, 6);
        if (map.taken_step_s)
            draw_step(plot, result, "scene takes", *map.taken_step_s, Mark::diamond, true, 4);
        else
            plot.legend_text("scene takes: none, it is stopped");
        return;
    }
    const PlotPoint point{result.axes.x.own.value_or(NAN), result.axes.y.own.value_or(NAN)};
    if (!within(plot_axis(result.axes.x), point.x) || !within(plot_axis(result.axes.y), point.y)) return;
    plot.mark(point, Mark::diamond, "#000000", true, 4);
    plot.legend_mark("the scene as it is", Mark::diamond, "#000000");
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
    draw_own_points(plot, result, map);
    return plot;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Numbers, booleans and arrays as such, bare words as texts.
Json value_json(const MapAxis& axis, std::size_t i) {
    if (!axis.labelled()) return axis.values[i];
    Json parsed = Json::parse(axis.labels[i], nullptr, false);
    return parsed.is_discarded() ? Json(axis.labels[i]) : parsed;
}

Json own_json(const MapAxis& axis) {
    if (!axis.own) return nullptr;
    return axis.labelled() ? value_json(axis, static_cast<std::size_t>(*axis.own)) : number(*axis.own);
}

Json axis_json(const MapAxis& axis) {
    Json json = {{"path", axis.path}, {"unit", axis.unit}, {"values", Json::array()}};
    for (std::size_t i = 0; i < axis.values.size(); ++i) json["values"].push_back(value_json(axis, i));
    json["logarithmic"] = axis.log;
    json["scene"] = own_json(axis);
    return json;
}

Json map_json(const StabilityMap& map) {
    Json json = {{"method", map.method},
                 {"classes", Json::array()},
                 {"reasons", map.reasons},
                 {"advised_step_s", Json::array()}};
    for (const CellClass kind : map.cells) json["classes"].push_back(to_string(kind));
    for (const double step : map.advised_s) json["advised_step_s"].push_back(number(step));
    json["scene_step_s"] = map.taken_step_s ? number(*map.taken_step_s) : Json(nullptr);
    return json;
}

std::string how_to_read(const StabilityResult& result) {
    std::string html = fmt::format(
        "<p>Each cell is a run of {}. <b>stable</b>: it moved like the same physics at a safe step. "
        "<b>degraded</b>: it ended, but moved more than {:g} times faster or slower than that (root mean "
        "square "
        "speed between frames). <b>diverged</b>: the module stopped it, since its values meant nothing. "
        "<b>refused</b>: the module would not begin, for the reasons above. <b>unknown</b>: there was no time "
        "for it or for its "
        "reference.</p>\n",
        seconds_text(result.duration_s), kSpeedFactor);
    if (result.axes.step_axis < 0) return html;
    return html +
           "<p>The line is the longest step that the adviser holds for stable, found without running. The "
           "square "
           "is the scene as it asks to be run: at its step, or at its frame where it names none. The diamond "
           "is "
           "the scene as it is run: at the step that it takes inside a frame.</p>\n";
}

/// A field of a CSV file (RFC 4180).
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + "\"";
}

}  // namespace

std::string stability_csv(const StabilityResult& result) {
    std::string csv = fmt::format("method,{},{},class\n", result.axes.x.path, result.axes.y.path);
    const MapAxes& axes = result.axes;
    for (const StabilityMap& map : result.maps)
        for (std::size_t i = 0; i < map.cells.size(); ++i)
            csv += fmt::format("{},{},{},{}\n", map.method, field(axes.x.text(axes.column(i))),
                               field(axes.y.text(axes.row(i))), to_string(map.cells[i]));
    return csv;
}

std::string stability_json(const StabilityResult& result) {
    Json json = {{"scene", result.scene},
                 {"table", result.table},
                 {"duration_s", result.duration_s},
                 {"asked_step_s", number(result.asked_step_s)},
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
