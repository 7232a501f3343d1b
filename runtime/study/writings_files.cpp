#include "study/writings_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "study/study_files.hpp"
#include "study/svg_plot.hpp"
#include "study/ways_files.hpp"

namespace orbweaver::study {

namespace {

using Json = nlohmann::ordered_json;

SvgPlot trade_plot(const WritingsResult& result) {
    std::vector<double> costs{0}, gains{0, 1};
    for (const TradeRow& row : result.trade) costs.push_back(row.outcome.silk_share);
    SvgPlot plot("legibility against nature",
                 axis_around("silk added and taken / silk of the plain web", costs, false),
                 axis_around("agreement with what was to be written", gains, false));
    for (std::size_t n = 0; n < result.ways.ways.size(); ++n) {
        const std::string& way = result.ways.ways[n].name;
        std::vector<PlotPoint> points, plain;
        for (const TradeRow& row : result.trade)
            if (row.way == way) {
                points.push_back({row.outcome.silk_share, row.outcome.iou});
                plain.push_back({0, row.outcome.plain_iou});
            }
        if (points.empty()) continue;
        std::sort(points.begin(), points.end(),
                  [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
        if (points.size() > 1) plot.line(points, color_of(n));
        for (const PlotPoint& point : points) plot.mark(point, mark_of(n), color_of(n), true, 5);
        plot.mark(plain.front(), mark_of(n), color_of(n), false, 5);
        plot.legend_mark(way, mark_of(n), color_of(n));
    }
    plot.legend_text("hollow: nothing written");
    return plot;
}

/// What is read may hold commas and quotes.
std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"") == std::string::npos) return text;
    std::string cell = "\"";
    for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + "\"";
}

/// The cell of CSV that begins there, which ends before a comma or a line's end.
std::string take_cell(const std::string& csv, std::size_t& at) {
    std::string cell;
    bool within_quotes = false;
    for (; within_quotes || (csv[at] != ',' && csv[at] != '\n'); ++at) {
        if (csv[at] != '"')
            cell += csv[at];
        else if (within_quotes && csv[at + 1] == '"')
            cell += csv[at++];
        else
            within_quotes = !within_quotes;
    }
    return cell;
}

std::string html_table(const std::string& csv) {
    std::string html = "<table>\n<tr>";
    bool head = true;
    for (std::size_t at = 0; at < csv.size(); ++at) {
        const std::string cell = escaped(take_cell(csv, at));
        html += head ? "<th>" + cell + "</th>" : "<td>" + cell + "</td>";
        if (csv[at] != '\n') continue;
        html += at + 1 < csv.size() ? "</tr>\n<tr>" : "</tr>\n";
        head = false;
    }
    return html + "</table>\n";
}

}  // namespace

std::string trade_csv(const WritingsResult& result) {
    std::string csv =
        "way,setting,iou,ssim,contrast,plain_iou,silk_share,max_tension_ratio,mean_shift_m,spacing_distance,"
        "new_slack\n";
    for (const auto& [way, setting, of] : result.trade)
        csv += fmt::format("{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.3g},{:.4f},{}\n", way, setting,
                           of.iou, of.ssim, of.contrast, of.plain_iou, of.silk_share, of.max_tension_ratio,
                           of.mean_shift, of.spacing_distance, of.new_slack);
    return csv;
}

std::string readings_csv(const WritingsResult& result) {
    std::string csv = "way,time_s,blurred,read,error,plain_error\n";
    for (const ReadingRow& row : result.readings)
        csv += fmt::format("{},{},{},{},{:.4f},{:.4f}\n", row.way, row.time, row.is_blurred, quoted(row.read),
                           row.error, row.plain_error);
    return csv;
}

std::string writings_json(const WritingsResult& result) {
    Json json = Json::parse(ways_json(result.ways));
    json["trade"] = Json::array();
    for (const auto& [way, setting, of] : result.trade)
        json["trade"].push_back({{"way", way},
                                 {"setting", setting},
                                 {"iou", of.iou},
                                 {"ssim", of.ssim},
                                 {"contrast", of.contrast},
                                 {"plain_iou", of.plain_iou},
                                 {"silk_share", of.silk_share},
                                 {"max_tension_ratio", of.max_tension_ratio},
                                 {"mean_shift_m", of.mean_shift},
                                 {"spacing_distance", of.spacing_distance},
                                 {"new_slack", of.new_slack}});
    json["readings"] = Json::array();
    for (const ReadingRow& row : result.readings)
        json["readings"].push_back({{"way", row.way},
                                    {"time_s", row.time},
                                    {"blurred", row.is_blurred},
                                    {"read", row.read},
                                    {"error", row.error},
                                    {"plain_error", row.plain_error}});
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string trade_svg(const WritingsResult& result) { return trade_plot(result).document(); }

std::string writings_page(const WritingsResult& result) {
    const WaysResult& ways = result.ways;
    return html_page(fmt::format("{}: {}", ways.scene, ways.words.title),
                     html_list(ways.sentences) + trade_svg(result) + ways_svg(ways) + "<p>" +
                         escaped(ways.words.reading) + "</p>\n<h2>Legibility and nature</h2>\n" +
                         html_table(trade_csv(result)) + "<h2>What is read</h2>\n" +
                         html_table(readings_csv(result)) + "<h2>By raster and by nature</h2>\n" +
                         html_table(ways_csv(ways)));
}

}  // namespace orbweaver::study
