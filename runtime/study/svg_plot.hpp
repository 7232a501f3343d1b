#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace orbweaver::study {

struct Axis {
    std::string label;  ///< with its unit
    double low = 0;
    double high = 1;
    bool log = false;
    std::vector<std::string> labels = {};  ///< what stands at 0, 1, 2, ... instead of numbers; empty: numbers
};

/// Where ticks stand: at powers of ten on a logarithmic axis (with 2 and 5 between them when it spans fewer
/// than three), at round numbers on a linear one, at each label where there are some.
std::vector<double> ticks(const Axis& axis);
/// Where a logarithmic axis is marked without a number: at every digit times a power of ten.
std::vector<double> minor_ticks(const Axis& axis);

/// A range that holds all these values and is never empty. On a logarithmic axis it ends at powers of ten and
/// values that are not positive take no part.
Axis axis_around(std::string label, std::span<const double> values, bool log);

struct PlotPoint {
    double x = 0;
    double y = 0;
};

enum class Mark : std::uint8_t { circle, square, triangle, diamond };

/// Color and mark of the n-th of several things: the colors of Okabe and Ito (2008), which color-blind eyes
/// tell apart, then the same with another mark.
std::string color_of(std::size_t n);
Mark mark_of(std::size_t n);

/// A plot with two axes, as SVG. Marks beyond an axis are drawn at its end, lines are cut off there; what is
/// not a number is left out. It grows where labels and legend need more than is usual.
class SvgPlot {
public:
    SvgPlot(std::string title, Axis x, Axis y, double width = 790, double height = 480);

    void line(std::span<const PlotPoint> points, const std::string& color, bool dashed = false,
              double width = 1.6);
    void mark(const PlotPoint& at, Mark mark, const std::string& color, bool filled = true, double size = 4);
    void cell(const PlotPoint& low, const PlotPoint& high, const std::string& color);
    /// An entry of the legend, right of the plot: a line, a mark, or a cell.
    void legend_line(const std::string& text, const std::string& color, bool dashed = false);
    void legend_mark(const std::string& text, Mark mark, const std::string& color, bool filled = true);
    void legend_cell(const std::string& text, const std::string& color);
    /// An entry that has nothing in the plot.
    void legend_text(const std::string& text);

    double width() const noexcept { return left_ + inner_width_ + legend_width_; }
    double height() const noexcept;
    /// The plot with its axes as elements of SVG, its upper left corner at the origin.
    std::string elements() const;
    /// A whole SVG document.
    std::string document() const;

private:
    double x_of(double value) const;
    double y_of(double value) const;
    void add_legend(const std::string& symbol, const std::string& text);
    double legend_x() const noexcept { return left_ + inner_width_ + 14; }
    double legend_y() const noexcept;
    std::string grid() const;
    std::string axes() const;

    std::string title_;
    Axis x_, y_;
    double left_, bottom_, inner_width_, inner_height_, legend_width_;
    std::string cells_, drawn_, legend_;
    int legends_ = 0;
};

/// Plots in rows of `columns`, as one SVG document.
std::string svg_grid(std::span<const SvgPlot> plots, std::size_t columns);

/// Text with &, <, > and quotes written as XML and HTML want them.
std::string escaped(const std::string& text);

}  // namespace orbweaver::study
