#include "study/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace orbweaver::study {

namespace {

constexpr double kLeft = 72;
constexpr double kTop = 34;
constexpr double kRight = 220;  // room for the legend
constexpr double kBottom = 52;
constexpr double kLegendRow = 19;
constexpr double kLetter = 7.2;  // px, of a wide sans-serif font of 12 px
constexpr double kSlope = 35;    // degrees, of labels that do not fit beside each other

/// Where a value lies along its axis: 0 at its low end, 1 at its high one; what is infinitely far is far.
double fraction(const Axis& axis, double value) {
    constexpr double kFar = 1e4;
    const double part = axis.log ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                                 : (value - axis.low) / (axis.high - axis.low);
    return std::clamp(part, -kFar, kFar);
}

double place(const Axis& axis, double value) { return std::clamp(fraction(axis, value), 0.0, 1.0); }

/// Cuts a segment off at the unit square; false when nothing of it lies within (Liang and Barsky 1984).
bool clip(PlotPoint& a, PlotPoint& b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    double first = 0;
    double last = 1;
    for (const auto& [change, room] :
         {std::pair(-dx, a.x), std::pair(dx, 1 - a.x), std::pair(-dy, a.y), std::pair(dy, 1 - a.y)}) {
        if (change == 0 && room < 0) return false;
        if (change < 0) first = std::max(first, room / change);
        if (change > 0) last = std::min(last, room / change);
    }
    const PlotPoint start = a;
    a = {start.x + first * dx, start.y + first * dy};
    b = {start.x + last * dx, start.y + last * dy};
    return first <= last;
}

double text_width(const std::string& text) { return kLetter * static_cast<double>(text.size()); }

double longest_label(const Axis& axis) {
    double longest = 0;
    for (const std::string& label : axis.labels) longest = std::max(longest, text_width(label));
    return longest;
}

bool has_sloping_labels(const Axis& axis, double width) {
    return longest_label(axis) * static_cast<double>(axis.labels.size()) > width;
}

bool can_be_placed(const Axis& axis, double value) { return !std::isnan(value) && (!axis.log || value >= 0); }

double round_spacing(double span) {
    const double power = std::pow(10, std::floor(std::log10(span / 5)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (span / (factor * power) <= 8) return factor * power;
    return 10 * power;
}

std::vector<double> log_ticks(const Axis& axis) {
    const int first = static_cast<int>(std::floor(std::log10(axis.low) + 1e-9));
    const int last = static_cast<int>(std::ceil(std::log10(axis.high) - 1e-9));
    const bool between = axis.high <= 100 * axis.low * (1 + 1e-9);
    const int stride = std::max(1, (last - first + 11) / 12);
    std::vector<double> all;
    for (int decade = first; decade <= last; decade += stride)
        for (const double factor : {1.0, 2.0, 5.0})
            if (factor == 1 || between) all.push_back(factor * std::pow(10, decade));
    return all;
}

/// Every label, or as many as have room.
std::vector<double> label_ticks(std::size_t count) {
    constexpr std::size_t kMost = 24;
    std::vector<double> all;
    for (std::size_t i = 0; i < count; i += (count + kMost - 1) / kMost) all.push_back(static_cast<double>(i));
    return all;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text, const char* more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escaped(text));
}

std::string tick_text(const Axis& axis, double value) {
    if (!axis.labels.empty()) return axis.labels[static_cast<std::size_t>(value)];
    if (!axis.log || (value >= 0.001 && value < 1000)) return fmt::format("{:.4g}", value);
    const int decade = static_cast<int>(std::floor(std::log10(value) + 1e-9));
    return fmt::format("{:.0f}e{}", value / std::pow(10, decade), decade);
}

std::string line_between(double x1, double y1, double x2, double y2, const std::string& color, double width,
                         bool dashed = false) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n",
        x1, y1, x2, y2, color, width, dashed ? " stroke-dasharray=\"6 4\"" : "");
}

std::string mark_at(double x, double y, Mark mark, const std::string& color, bool filled, double r) {
    const std::string paint =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.4\"", filled ? color : "white", color);
    const auto polygon = [&](std::string points) {
        return fmt::format("<polygon points=\"{}\" {}/>\n", points, paint);
    };
    switch (mark) {
        case Mark::circle:
            return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", x, y, r, paint);
        case Mark::square:
            return fmt::format("<rect x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2}\" height=\"{2}\" {3}/>\n", x - r,
                               y - r, 2 * r, paint);
        case Mark::triangle:
            return polygon(fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}", x, y - 1.2 * r, x + 1.1 * r,
                                       y + 0.8 * r, x - 1.1 * r, y + 0.8 * r));
        default:
            return polygon(fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}", x,
                                       y - 1.3 * r, x + 1.3 * r, y, x, y + 1.3 * r, x - 1.3 * r, y));
    }
}

std::string framed(double width, double height, const std::string& elements) {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\" font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<rect width=\"100%\" "
        "height=\"100%\" fill=\"white\"/>\n{2}</svg>\n",
        width, height, elements);
}

}  // namespace

std::vector<double> ticks(const Axis& axis) {
    if (!axis.labels.empty()) return label_ticks(axis.labels.size());
    std::vector<double> all;
    if (axis.log) {
        all = log_ticks(axis);
    } else {
        const double spacing = round_spacing(axis.high - axis.low);
        const double first = std::ceil(axis.low / spacing - 1e-9);
        for (double i = first; i * spacing <= axis.high + 1e-9 * spacing; ++i)
            all.push_back(i * spacing + 0.0);  // no -0
    }
    constexpr double kRounding = 1e-9;
    std::erase_if(all, [&](double tick) {
        const double slack = kRounding * (axis.log ? tick : axis.high - axis.low);
        return tick < axis.low - slack || tick > axis.high + slack;
    });
    return all;
}

std::vector<double> minor_ticks(const Axis& axis) {
    constexpr double kMostDecades = 12;
    std::vector<double> all;
    if (!axis.log || std::log10(axis.high / axis.low) > kMostDecades) return all;
    const int first = static_cast<int>(std::floor(std::log10(axis.low)));
    for (int decade = first; decade <= std::log10(axis.high); ++decade)
        for (int digit = 1; digit < 10; ++digit)
            if (const double tick = digit * std::pow(10, decade); tick >= axis.low && tick <= axis.high)
                all.push_back(tick);
    return all;
}

Axis axis_around(std::string label, std::span<const double> values, bool log) {
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const double value : values) {
        if (!std::isfinite(value) || (log && value <= 0)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (low > high) return {std::move(label), log ? 0.1 : 0, log ? 10.0 : 1, log};
    if (!log) return {std::move(label), low, high > low ? high : low + 1, false};
    const double first = std::floor(std::log10(low) + 1e-9);
    const double last = std::max(first + 1, std::ceil(std::log10(high) - 1e-9));
    return {std::move(label), std::pow(10, first), std::pow(10, last), true};
}

std::string color_of(std::size_t n) {
    static constexpr std::array<const char*, 7> colors = {"#0072b2", "#e69f00", "#009e73", "#d55e00",
                                                          "#cc79a7", "#56b4e9", "#000000"};
    return colors[n % colors.size()];
}

Mark mark_of(std::size_t n) { return static_cast<Mark>((n + 2 * (n / 7)) % 4); }

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '&')
            safe += "&amp;";
        else if (c == '<')
            safe += "&lt;";
        else if (c == '>')
            safe += "&gt;";
        else if (c == '"')
            safe += "&quot;";
        else
            safe += c;
    }
    return safe;
}

SvgPlot::SvgPlot(std::string title, Axis x, Axis y, double width, double height)
    : title_(std::move(title)),
      x_(std::move(x)),
      y_(std::move(y)),
      left_(std::max(kLeft, longest_label(y_) + 40)),
      bottom_(kBottom),
      inner_width_(width - kLeft - kRight),
      inner_height_(height - kTop - kBottom),
      legend_width_(kRight) {
    if (has_sloping_labels(x_, inner_width_)) bottom_ += longest_label(x_) * std::sin(kSlope * 3.14159 / 180);
}

double SvgPlot::height() const noexcept {
    return std::max(kTop + inner_height_ + bottom_, legend_y() + kLegendRow);
}
double SvgPlot::x_of(double value) const { return left_ + place(x_, value) * inner_width_; }
double SvgPlot::y_of(double value) const { return kTop + (1 - place(y_, value)) * inner_height_; }

void SvgPlot::line(std::span<const PlotPoint> points, const std::string& color, bool dashed, double width) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PlotPoint& from = points[i - 1];
        const PlotPoint& to = points[i];
        if (!can_be_placed(x_, from.x) || !can_be_placed(y_, from.y) || !can_be_placed(x_, to.x) ||
            !can_be_placed(y_, to.y))
            continue;
        PlotPoint a{fraction(x_, from.x), fraction(y_, from.y)};
        PlotPoint b{fraction(x_, to.x), fraction(y_, to.y)};
        if (clip(a, b))
            drawn_ += line_between(left_ + a.x * inner_width_, kTop + (1 - a.y) * inner_height_,
                                   left_ + b.x * inner_width_, kTop + (1 - b.y) * inner_height_, color, width,
                                   dashed);
    }
}

void SvgPlot::mark(const PlotPoint& at, Mark mark, const std::string& color, bool filled, double size) {
    if (can_be_placed(x_, at.x) && can_be_placed(y_, at.y))
        drawn_ += mark_at(x_of(at.x), y_of(at.y), mark, color, filled, size);
}

void SvgPlot::cell(const PlotPoint& low, const PlotPoint& high, const std::string& color) {
    cells_ += fmt::format(
        "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" stroke=\"white\" "
        "stroke-width=\"0.6\"/>\n",
        x_of(low.x), y_of(high.y), x_of(high.x) - x_of(low.x), y_of(low.y) - y_of(high.y), color);
}

double SvgPlot::legend_y() const noexcept { return kTop + 10 + kLegendRow * legends_; }

void SvgPlot::add_legend(const std::string& symbol, const std::string& text) {
    legend_ += symbol + text_at(legend_x() + 28, legend_y() + 4, "start", text);
    legend_width_ = std::max(legend_width_, 14 + 28 + text_width(text) + 8);
    ++legends_;
}

void SvgPlot::legend_line(const std::string& text, const std::string& color, bool dashed) {
    const double y = legend_y();
    add_legend(line_between(legend_x(), y, legend_x() + 22, y, color, 1.8, dashed), text);
}

void SvgPlot::legend_mark(const std::string& text, Mark mark, const std::string& color, bool filled) {
    add_legend(mark_at(legend_x() + 11, legend_y(), mark, color, filled, 4), text);
}

void SvgPlot::legend_cell(const std::string& text, const std::string& color) {
    add_legend(fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"16\" height=\"12\" fill=\"{}\"/>\n",
                           legend_x() + 3, legend_y() - 6, color),
               text);
}

void SvgPlot::legend_text(const std::string& text) { add_legend("", text); }

std::string SvgPlot::grid() const {
    std::string svg;
    for (const double tick : ticks(x_))
        svg += line_between(x_of(tick), y_of(y_.low), x_of(tick), y_of(y_.high), "#e4e4e4", 1);
    for (const double tick : ticks(y_))
        svg += line_between(x_of(x_.low), y_of(tick), x_of(x_.high), y_of(tick), "#e4e4e4", 1);
    return svg;
}

std::string SvgPlot::axes() const {
    const double left = x_of(x_.low);
    const double right = x_of(x_.high);
    const double bottom = y_of(y_.low);
    const double top = y_of(y_.high);
    const bool sloping = has_sloping_labels(x_, inner_width_);
    std::string svg;
    for (const double tick : ticks(x_)) {
        const double x = x_of(tick);
        const std::string turn =
            sloping ? fmt::format(" transform=\"rotate(-{} {:.1f} {:.1f})\"", kSlope, x + 4, bottom + 17) : "";
        svg += line_between(x, bottom, x, bottom + 5, "#444", 1) + text_at(sloping ? x + 4 : x, bottom + 17,
                                                                           sloping ? "end" : "middle",
                                                                           tick_text(x_, tick), turn.c_str());
    }
    for (const double tick : ticks(y_))
        svg += line_between(left - 5, y_of(tick), left, y_of(tick), "#444", 1) +
               text_at(left - 8, y_of(tick) + 4, "end", tick_text(y_, tick));
    for (const double tick : minor_ticks(x_))
        svg += line_between(x_of(tick), bottom, x_of(tick), bottom + 3, "#888", 1);
    for (const double tick : minor_ticks(y_))
        svg += line_between(left - 3, y_of(tick), left, y_of(tick), "#888", 1);
    svg +=
        line_between(left, bottom, right, bottom, "#444", 1) + line_between(left, bottom, left, top, "#444", 1);
    svg += text_at((left + right) / 2, bottom + bottom_ - 12, "middle", x_.label);
    svg += text_at(18, (top + bottom) / 2, "middle", y_.label,
                   fmt::format(" transform=\"rotate(-90 18 {:.1f})\"", (top + bottom) / 2).c_str());
    return svg + text_at(left, 20, "start", title_, " font-size=\"14\" font-weight=\"bold\"");
}

std::string SvgPlot::elements() const { return grid() + cells_ + axes() + drawn_ + legend_; }
std::string SvgPlot::document() const { return framed(width(), height(), elements()); }

std::string svg_grid(std::span<const SvgPlot> plots, std::size_t columns) {
    double width = 0;
    double height = 0;
    for (const SvgPlot& plot : plots) {
        width = std::max(width, plot.width());
        height = std::max(height, plot.height());
    }
    std::string all;
    for (std::size_t i = 0; i < plots.size(); ++i) {
        const std::size_t row = i / columns;
        all += fmt::format("<g transform=\"translate({:.0f} {:.0f})\">\n{}</g>\n",
                           static_cast<double>(i % columns) * width, static_cast<double>(row) * height,
                           plots[i].elements());
    }
    const auto rows = (plots.size() + columns - 1) / columns;
    return framed(width * static_cast<double>(std::min(columns, plots.size())),
                  height * static_cast<double>(rows), all);
}

}  // namespace orbweaver::study
