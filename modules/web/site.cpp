#include "site.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace orbweaver::web {

namespace {

constexpr double kCoincident = 1e-4;  // of the anchors' extent
constexpr double kCollinear = 1e-2;   // width of the anchors over their length
constexpr double kClearance = 0.15;   // of the mean anchor distance: nearer to a side is no middle

std::string show(std::span<const Vec3> anchors, std::size_t i) {
    const Vec3& p = anchors[i];
    return fmt::format("anchor {} at ({:.6g}, {:.6g}, {:.6g}) m", i + 1, p.x, p.y, p.z);
}

void report(Diagnostics& faults, std::string what, std::string expected, std::string remedy) {
    faults.push_back({{}, std::move(what), std::move(expected), std::move(remedy)});
}

bool check_values(std::span<const Vec3> anchors, Diagnostics& faults) {
    if (anchors.size() < 3 || anchors.size() > kMostAnchors) {
        report(faults, fmt::format("the web has {} anchor{}", anchors.size(), anchors.size() == 1 ? "" : "s"),
               fmt::format("3 to {}", kMostAnchors), "give the points it hangs from, in order around it");
        return false;
    }
    const std::size_t before = faults.size();
    for (std::size_t i = 0; i < anchors.size(); ++i)
        if (!is_finite(anchors[i]))
            report(faults, show(anchors, i) + " is not a point", "finite coordinates", "");
    return faults.size() == before;
}

double extent(std::span<const Vec3> anchors) {
    double largest = 0;
    for (const Vec3& p : anchors) largest = std::max(largest, distance(p, anchors.front()));
    return largest;
}

bool check_apart(std::span<const Vec3> anchors, Diagnostics& faults) {
    const std::size_t before = faults.size();
    const double nearest = kCoincident * extent(anchors);
    for (std::size_t i = 0; i < anchors.size(); ++i)
        for (std::size_t j = i + 1; j < anchors.size(); ++j)
            if (distance(anchors[i], anchors[j]) <= nearest)
                report(faults, fmt::format("{} and {} coincide", show(anchors, i), show(anchors, j)),
                       "anchors in different places", "move or remove one of them");
    return faults.size() == before;
}

using Polygon = std::vector<PlanePoint>;

bool cross_each_other(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool check_order(std::span<const Vec3> anchors, const Polygon& polygon, Diagnostics& faults) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (!cross_each_other(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n])) continue;
            report(faults,
                   fmt::format("the frame thread from {} to anchor {} crosses the one from {} to anchor {}",
                               show(anchors, i), (i + 1) % n + 1, show(anchors, j), (j + 1) % n + 1),
                   "anchors in order around the web", "list them in the order of a walk around it");
            return false;
        }
    return true;
}

double twice_area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) sum += turn(polygon[0], polygon[i], polygon[i + 1]);
    return sum;
}

PlanePoint middle_of_bounding_box(const Polygon& polygon) {
    PlanePoint low = polygon.front();
    PlanePoint high = low;
    for (const PlanePoint& p : polygon) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {(low.x + high.x) / 2, (low.y + high.y) / 2};
}

PlanePoint centroid_of_area(const Polygon& polygon) {
    PlanePoint sum;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const double weight = turn(polygon[0], polygon[i], polygon[i + 1]) / 3;
        sum.x += weight * (polygon[0].x + polygon[i].x + polygon[i + 1].x);
        sum.y += weight * (polygon[0].y + polygon[i].y + polygon[i + 1].y);
    }
    const double total = twice_area(polygon);
    return {sum.x / total, sum.y / total};
}

double length(const PlanePoint& a, const PlanePoint& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

struct View {
    double clearance = std::numeric_limits<double>::infinity();  ///< over the mean anchor distance
    std::size_t side = 0;                                        ///< the side it is nearest to
};

/// How well a point sees every side of a counter-clockwise polygon from inside; negative: it does not.
View view_from(const PlanePoint& p, const Polygon& polygon) {
    const std::size_t n = polygon.size();
    double mean = 0;
    for (const PlanePoint& q : polygon) mean += length(p, q) / static_cast<double>(n);
    View view;
    for (std::size_t i = 0; i < n; ++i) {
        const PlanePoint& a = polygon[i];
        const PlanePoint& b = polygon[(i + 1) % n];
        const double clearance = turn(a, b, p) / (length(a, b) * mean);
        if (clearance < view.clearance) view = {clearance, i};
    }
    return view;
}

PlanePoint choose_center(const Polygon& polygon) {
    const PlanePoint middle = middle_of_bounding_box(polygon);
    if (view_from(middle, polygon).clearance >= kClearance) return middle;
    const PlanePoint centroid = centroid_of_area(polygon);
    return view_from(centroid, polygon).clearance > view_from(middle, polygon).clearance ? centroid : middle;
}

/// The sides of `polygon` by the scene's numbering of its anchors.
class Numbering {
public:
    Numbering(std::size_t count, bool turned) noexcept : count_(count), turned_(turned) {}
    std::size_t of(std::size_t i) const noexcept {
        i %= count_;
        return turned_ && i != 0 ? count_ - i : i;
    }

private:
    std::size_t count_;
    bool turned_;
};

bool check_center(const Vec3& center, const View& view, std::span<const Vec3> anchors,
                  const Numbering& numbering, Diagnostics& faults) {
    constexpr double kLeast = 0.02;
    if (view.clearance >= kLeast) return true;
    const auto [first, second] = std::minmax({numbering.of(view.side), numbering.of(view.side + 1)});
    report(
        faults,
        fmt::format("the web's center at ({:.6g}, {:.6g}, {:.6g}) m does not see the frame thread from {} to "
                    "anchor {} from inside",
                    center.x, center.y, center.z, show(anchors, first), second + 1),
        "anchors all around the center", "move those anchors outwards, or choose another 'center'");
    return false;
}

}  // namespace

std::optional<Site> survey(std::span<const Vec3> anchors, std::optional<Vec3> center, Diagnostics& faults) {
    if (!check_values(anchors, faults) || !check_apart(anchors, faults)) return std::nullopt;
    const PlaneFit fit = fit_plane(anchors);
    if (fit.width < kCollinear * fit.length) {
        report(faults, fmt::format("the {} anchors lie on one line", anchors.size()),
               "anchors all around an area", "move at least one of them off the line");
        return std::nullopt;
    }
    Polygon polygon;
    for (const Vec3& p : anchors) polygon.push_back(fit.plane.project(p));
    if (!check_order(anchors, polygon, faults)) return std::nullopt;

    Site site;
    site.anchors.assign(anchors.begin(), anchors.end());
    const bool turned = twice_area(polygon) < 0;
    if (turned) {
        std::reverse(polygon.begin() + 1, polygon.end());
        std::reverse(site.anchors.begin() + 1, site.anchors.end());
    }
    const PlanePoint middle = center ? fit.plane.project(*center) : choose_center(polygon);
    site.center_given = center.has_value();
    site.center = center ? *center : fit.plane.lift(middle);
    site.plane = fit.plane;
    site.plane.origin = site.center;
    const Numbering numbering(anchors.size(), turned);
    if (!check_center(site.center, view_from(middle, polygon), anchors, numbering, faults)) return std::nullopt;
    return site;
}

}  // namespace orbweaver::web
