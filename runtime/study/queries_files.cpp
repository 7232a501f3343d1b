#include "study/queries_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/study_files.hpp"
#include "study/subject.hpp"
#include "study/svg_plot.hpp"

namespace orbweaver::study {

namespace {

using Json = nlohmann::ordered_json;

std::size_t number_of(const QueryResult& result, const std::string& way) {
    const auto found = std::find_if(result.ways.begin(), result.ways.end(),
                                    [&](const QueryResult::Named& each) { return each.name == way; });
    return static_cast<std::size_t>(found - result.ways.begin());
}

/// All plots have the same axes, so that they can be held against each other.
std::vector<SvgPlot> plots(const QueryResult& result) {
    std::vector<double> costs, errors;
    for (const QueryRow& row : result.rows) {
        costs.push_back(row.cost_s);
        errors.push_back(row.error_m);
    }
    const Axis x = axis_around("time a question / s", costs, true);
    const Axis y = axis_around("largest error / m", errors, true);
    std::vector<SvgPlot> all;
    for (const auto& set : result.sets) {
        SvgPlot plot(fmt::format("{}: {}", set.name, set.meaning), x, y, 700, 340);
        for (const QueryRow& row : result.rows_of(set.name)) {
            const std::size_t n = number_of(result, row.way);
            const bool sound = row.missed + row.invented == 0;
            plot.mark({row.cost_s, row.error_m}, mark_of(n), color_of(n), sound, 5);
            plot.legend_mark(fmt::format("{}, {}{}", row.way, seconds_text(row.cost_s),
                                         sound ? "" : fmt::format(", misses {}", row.missed + row.invented)),
                             mark_of(n), color_of(n), sound);
        }
        all.push_back(std::move(plot));
    }
    return all;
}

Json named(const std::vector<QueryResult::Named>& all) {
    Json json = Json::array();
    for (const auto& each : all) json.push_back({{"name", each.name}, {"meaning", each.meaning}});
    return json;
}

std::string html_rows(const QueryResult& result) {
    std::string html =
        "<table><tr><th>questions</th><th>way</th><th>asked</th><th>missed</th><th>invented</th>"
        "<th>largest error / m</th><th>median error / m</th><th>time a question</th></tr>\n";
    for (const QueryRow& row : result.rows)
        html += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.2e}</td><td>{:.2e}</td><td>{}</"
            "td>"
            "</tr>\n",
            escaped(row.questions), escaped(row.way), row.asked, row.missed, row.invented, row.error_m,
            row.median_error_m, seconds_text(row.cost_s));
    return html + "</table>\n";
}

std::string html_named(const std::vector<QueryResult::Named>& all) {
    std::string html = "<table>\n";
    for (const auto& each : all)
        html += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(each.name), escaped(each.meaning));
    return html + "</table>\n";
}

constexpr const char* kHowToRead =
    "<p>Each mark is a way of asking the same questions: what one takes, and how far at most the place found "
    "lies from where it should. Lower left is better; errors of 0 lie on the lower edge; hollow marks miss "
    "something or find what is not there. The reference asks every triangle in extended precision, and knows "
    "nothing of trees, neighbours or walks; where a ray meets nothing but a rim, to hit it and to pass it are "
    "both right. Beyond an edge the reference is the nearest point of the surface. Times are medians, of "
    "questions asked one after the other by one thread.</p>\n";

}  // namespace

std::string queries_csv(const QueryResult& result) {
    std::string csv = "questions,way,asked,missed,invented,error_m,median_error_m,cost_s\n";
    for (const QueryRow& row : result.rows)
        csv += fmt::format("{},{},{},{},{},{},{},{}\n", row.questions, row.way, row.asked, row.missed,
                           row.invented, row.error_m, row.median_error_m, row.cost_s);
    return csv;
}

std::string queries_json(const QueryResult& result) {
    Json json = {{"scene", result.scene}, {"triangles", result.triangles},   {"size_m", result.size_m},
                 {"seed", result.seed},   {"questions", named(result.sets)}, {"ways", named(result.ways)},
                 {"rows", Json::array()}};
    for (const QueryRow& row : result.rows)
        json["rows"].push_back({{"questions", row.questions},
                                {"way", row.way},
                                {"asked", row.asked},
                                {"missed", row.missed},
                                {"invented", row.invented},
                                {"error_m", row.error_m},
                                {"median_error_m", row.median_error_m},
                                {"cost_s", row.cost_s}});
    json["sentences"] = result.sentences;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string queries_svg(const QueryResult& result) { return svg_grid(plots(result), 2); }

std::string queries_page(const QueryResult& result) {
    std::string body = html_list(result.sentences) + queries_svg(result) + kHowToRead;
    body += "<h2>Questions</h2>\n" + html_named(result.sets) + "<h2>Ways of asking</h2>\n" +
            html_named(result.ways);
    body += "<h2>Every way</h2>\n" + html_rows(result);
    return html_page(fmt::format("{}: queries of its surface, {} triangles", result.scene, result.triangles),
                     body);
}

}  // namespace orbweaver::study
