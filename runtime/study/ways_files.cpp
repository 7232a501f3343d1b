#include "study/ways_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/study_files.hpp"
#include "study/subject.hpp"
#include "study/svg_plot.hpp"

namespace orbweaver::study {

namespace {

using Json = nlohmann::ordered_json;

std::vector<WayRow> rows_by(const std::vector<WayRow>& rows, const std::string& way) {
    std::vector<WayRow> found;
    for (const WayRow& row : rows)
        if (row.way == way) found.push_back(row);
    return found;
}

bool is_sound(const WayRow& row) { return row.missed + row.invented == 0; }

/// What one way did, as a line of marks: one for each setting.
void draw(const std::vector<WayRow>& rows, std::size_t n, SvgPlot& plot) {
    std::vector<PlotPoint> line;
    line.reserve(rows.size());
    for (const WayRow& row : rows) line.push_back({row.cost_s, row.error});
    if (line.size() > 1) plot.line(line, color_of(n));
    std::size_t missed = 0;
    for (const WayRow& row : rows) {
        plot.mark({row.cost_s, row.error}, mark_of(n), color_of(n), is_sound(row), 5);
        missed = std::max(missed, row.missed + row.invented);
    }
    const std::string cost = rows.size() == 1 ? ", " + seconds_text(rows[0].cost_s) : "";
    plot.legend_mark(rows[0].way + cost + (missed == 0 ? "" : fmt::format(", misses {}", missed)), mark_of(n),
                     color_of(n), missed == 0);
}

/// All plots have the same axes, so that they can be held against each other.
std::vector<SvgPlot> plots(const WaysResult& result) {
    std::vector<double> costs, errors;
    for (const WayRow& row : result.rows) {
        costs.push_back(row.cost_s);
        errors.push_back(row.error);
    }
    const Axis x = axis_around(fmt::format("time a {} / s", result.words.task), costs, true);
    const Axis y = axis_around(result.words.error, errors, true);
    std::vector<SvgPlot> all;
    for (const Named& set : result.tasks) {
        SvgPlot plot(fmt::format("{}: {}", set.name, set.meaning), x, y, 700, 340);
        const auto rows = result.rows_of(set.name);
        for (std::size_t n = 0; n < result.ways.size(); ++n)
            if (const auto by = rows_by(rows, result.ways[n].name); !by.empty()) draw(by, n, plot);
        all.push_back(std::move(plot));
    }
    return all;
}

Json named(const std::vector<Named>& all) {
    Json json = Json::array();
    for (const Named& each : all) json.push_back({{"name", each.name}, {"meaning", each.meaning}});
    return json;
}

std::string unit_suffix(const WaysResult& result) {
    return result.words.unit.empty() ? "" : "_" + result.words.unit;
}

std::string html_rows(const WaysResult& result) {
    const bool settings = result.words.has_settings;
    std::string html = fmt::format(
        "<table><tr><th>{}</th><th>way</th>{}<th>asked</th><th>missed</th><th>invented</th>"
        "<th>{}</th><th>median</th><th>time a {}</th></tr>\n",
        escaped(result.words.tasks), settings ? "<th>setting</th>" : "", escaped(result.words.error),
        escaped(result.words.task));
    for (const WayRow& row : result.rows)
        html += fmt::format(
            "<tr><td>{}</td><td>{}</td>{}<td>{}</td><td>{}</td><td>{}</td><td>{:.2e}</td><td>{:.2e}</"
            "td><td>{}</"
            "td></tr>\n",
            escaped(row.tasks), escaped(row.way), settings ? "<td>" + escaped(row.setting) + "</td>" : "",
            row.asked, row.missed, row.invented, row.error, row.median_error, seconds_text(row.cost_s));
    return html + "</table>\n";
}

std::string html_named(const std::vector<Named>& all) {
    std::string html = "<table>\n";
    for (const Named& each : all)
        html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(each.name), escaped(each.meaning));
    return html + "</table>\n";
}

}  // namespace

std::string ways_csv(const WaysResult& result) {
    const bool settings = result.words.has_settings;
    const std::string unit = unit_suffix(result);
    std::string csv = fmt::format("{},way,{}asked,missed,invented,error{},median_error{},cost_s\n",
                                  result.words.tasks, settings ? "setting," : "", unit, unit);
    for (const WayRow& row : result.rows)
        csv += fmt::format("{},{},{}{},{},{},{},{},{}\n", row.tasks, row.way, settings ? row.setting + "," : "",
                           row.asked, row.missed, row.invented, row.error, row.median_error, row.cost_s);
    return csv;
}

std::string ways_json(const WaysResult& result) {
    Json json = {{"scene", result.scene}};
    for (const auto& [name, value] : result.facts)
        std::visit([&, &key = name](auto figure) { json[key] = figure; }, value);
    json[result.words.tasks] = named(result.tasks);
    json["ways"] = named(result.ways);
    json["rows"] = Json::array();
    const std::string unit = unit_suffix(result);
    for (const WayRow& row : result.rows) {
        Json& at = json["rows"].emplace_back();
        at = {{result.words.tasks, row.tasks}, {"way", row.way}};
        if (result.words.has_settings) at["setting"] = row.setting;
        at["asked"] = row.asked;
        at["missed"] = row.missed;
        at["invented"] = row.invented;
        at["error" + unit] = row.error;
        at["median_error" + unit] = row.median_error;
        at["cost_s"] = row.cost_s;
    }
    json["sentences"] = result.sentences;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string ways_svg(const WaysResult& result) { return svg_grid(plots(result), 2); }

std::string ways_page(const WaysResult& result) {
    std::string body = html_list(result.sentences) + ways_svg(result) + "<p>" + escaped(result.words.reading) +
                       "</p>\n" + "<h2>Tasks</h2>\n" + html_named(result.tasks) + "<h2>Ways</h2>\n" +
                       html_named(result.ways) + "<h2>Every way</h2>\n" + html_rows(result);
    return html_page(fmt::format("{}: {}", result.scene, result.words.title), body);
}

}  // namespace orbweaver::study
