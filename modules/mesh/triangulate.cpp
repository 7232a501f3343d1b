#include "triangulate.hpp"

#include <algorithm>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver::mesh {

namespace {

Vec3 newell_normal(std::span<const Vec3> points, std::span<const std::uint32_t> polygon) {
    const Vec3& origin = points[polygon[0]];
    Vec3 normal;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += cross(points[polygon[i]] - origin, points[polygon[i + 1]] - origin);
    return normal;
}

/// Cuts off one ear after the other.
class EarCutter {
public:
    EarCutter(std::span<const Vec3> points, std::span<const std::uint32_t> polygon, const Vec3& normal)
        : points_(points), rest_(polygon.begin(), polygon.end()), normal_(normal), fatness_(polygon.size()) {
        for (std::size_t i = 0; i < rest_.size(); ++i) fatness_[i] = fatness(i);
    }

    void cut(std::vector<Triangle>& into) {
        while (rest_.size() > 3) {
            const auto fattest = std::max_element(fatness_.begin(), fatness_.end());
            if (*fattest <= 0) break;
            const auto ear = static_cast<std::size_t>(fattest - fatness_.begin());
            into.push_back({rest_[before(ear)], rest_[ear], rest_[after(ear)]});
            remove(ear);
        }
        for (std::size_t i = 1; i + 1 < rest_.size(); ++i) into.push_back({rest_[0], rest_[i], rest_[i + 1]});
    }

private:
    std::size_t before(std::size_t i) const noexcept { return (i == 0 ? rest_.size() : i) - 1; }
    std::size_t after(std::size_t i) const noexcept { return i + 1 == rest_.size() ? 0 : i + 1; }

    double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
        return dot(normal_, cross(points_[b] - points_[a], points_[c] - points_[a]));
    }

    /// How far from a sliver the triangle at a corner is; 0 or less where it is no ear.
    double fatness(std::size_t i) const noexcept {
        const std::uint32_t a = rest_[before(i)], b = rest_[i], c = rest_[after(i)];
        const double area = turn(a, b, c);
        if (!(area > 0)) return 0;
        for (const std::uint32_t p : rest_)
            if (p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0)
                return 0;
        const auto squared = [&](std::uint32_t from, std::uint32_t to) {
            return dot(points_[to] - points_[from], points_[to] - points_[from]);
        };
        return area / std::max({squared(a, b), squared(b, c), squared(c, a)});
    }

    void remove(std::size_t ear) {
        rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
        fatness_.erase(fatness_.begin() + static_cast<std::ptrdiff_t>(ear));
        const std::size_t right = ear == rest_.size() ? 0 : ear;
        fatness_[right] = fatness(right);
        fatness_[before(right)] = fatness(before(right));
    }

    std::span<const Vec3> points_;
    std::vector<std::uint32_t> rest_;
    Vec3 normal_;
    std::vector<double> fatness_;
};

}  // namespace

void triangulate(std::span<const Vec3> points, std::span<const std::uint32_t> polygon,
                 std::vector<Triangle>& into) {
    const Vec3 normal = newell_normal(points, polygon);
    const Vec3& origin = points[polygon[0]];
    bool is_fan = true;
    for (std::size_t i = 1; i + 1 < polygon.size() && polygon.size() > 3; ++i)
        is_fan = is_fan && dot(normal, cross(points[polygon[i]] - origin, points[polygon[i + 1]] - origin)) > 0;
    if (is_fan) {
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            into.push_back({polygon[0], polygon[i], polygon[i + 1]});
        return;
    }
    if (polygon.size() > kMostEars)
        throw Fault(FaultKind::limit, "a polygon of " + std::to_string(polygon.size()) +
                                          " corners is not convex; expected at most " +
                                          std::to_string(kMostEars) + " corners, so split it");
    EarCutter(points, polygon, normal).cut(into);
}

}  // namespace orbweaver::mesh
