#include "import_rounding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver {

namespace {

constexpr double kSmallestNormal = std::numeric_limits<float>::min();

/// m, half the way from a single precision number to the next.
double half_ulp(double coordinate) {
    const auto x = static_cast<float>(std::abs(coordinate));
    return (static_cast<double>(std::nextafter(x, HUGE_VALF)) - static_cast<double>(x)) / 2;
}

double rounding_of(const Vec3& p) { return norm(Vec3{half_ulp(p.x), half_ulp(p.y), half_ulp(p.z)}); }

double farthest_of(const Vec3& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

/// Calls visit(polygon, from, to) for each edge of each polygon.
template <class Visit>
void for_each_edge(const mesh::RawMesh& raw, Visit&& visit) {
    for (std::uint32_t p = 0; p < raw.polygon_count(); ++p)
        for (std::uint32_t c = raw.first[p], last = raw.first[p + 1] - 1; c < raw.first[p + 1]; last = c++)
            visit(p, raw.points[raw.corners[last]], raw.points[raw.corners[c]]);
}

double mean_edge(const mesh::RawMesh& raw) {
    double sum = 0;
    for_each_edge(raw, [&](std::uint32_t, const Vec3& a, const Vec3& b) { sum += distance(a, b); });
    return sum / static_cast<double>(raw.corners.size());
}

}  // namespace

ImportRounding import_rounding(const mesh::RawMesh& raw) {
    ImportRounding found;
    const double mean = mean_edge(raw);
    std::uint32_t last = mesh::kNone;
    for_each_edge(raw, [&](std::uint32_t polygon, const Vec3& a, const Vec3& b) {
        const double length = distance(a, b);
        const double a_off = rounding_of(a), b_off = rounding_of(b);
        if (a_off + b_off <= kToldChange * (length > 0 ? length : mean)) return;
        found.worst = std::max({found.worst, a_off, b_off});
        found.farthest = std::max({found.farthest, farthest_of(a), farthest_of(b)});
        if (polygon == last) return;
        last = polygon;
        if (found.polygons++ == 0) found.first = polygon;
    });
    return found;
}

std::string rounding_sentence(const ImportRounding& rounding, const mesh::RawMesh& raw,
                              const std::string& name) {
    const bool tiny = rounding.farthest < kSmallestNormal / kToldChange;
    return fmt::format(
        "{}: {} of {} polygons, the first of them {}, may have edges more than {:g} % too long or too short: "
        "meshes "
        "are imported in single precision, in which {}; {}",
        name, rounding.polygons, raw.polygon_count(), rounding.first, 100 * kToldChange,
        tiny ? fmt::format("lengths as small as {:.2g} m lose their digits", kSmallestNormal)
             : fmt::format("a point {:.3g} m from the file's origin may lie {:.2g} m beside its place",
                           rounding.farthest, rounding.worst),
        tiny ? "scale its file up, and give the size that it should have by 'size' in the scene"
             : "move the mesh to its file's origin, and give the place where it belongs by 'position' in the "
               "scene");
}

}  // namespace orbweaver
