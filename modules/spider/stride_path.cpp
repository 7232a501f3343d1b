#include "stride_path.hpp"

#include <algorithm>
#include <array>

#include "rotor.hpp"
#include "unit.hpp"

namespace orbweaver::spider {
namespace {

SwingPoint cycloid(double s) noexcept {
    const Rotor<double> turn = rotor(2 * kPi * s - kPi);  // half a turn behind
    return {s + turn.s / (2 * kPi), (1 + turn.c) / 2};
}

SwingPoint arc(double s) noexcept { return {s, 4 * s * (1 - s)}; }

/// Eased at both ends.
double smooth(double s) noexcept { return s * s * (3 - 2 * s); }

SwingPoint reach(double s) noexcept {
    // Highest at a third of the way, where little of the length is done.
    const double rise = 27.0 / 4 * s * (1 - s) * (1 - s);
    return {smooth(s) * smooth(s), rise};
}

SwingPoint creep(double s) noexcept {
    const double late = 27.0 / 4 * s * s * (1 - s);
    return {1 - (1 - smooth(s)) * (1 - smooth(s)), late};
}

}  // namespace

std::span<const StridePath> stride_paths() noexcept {
    static constexpr std::array<StridePath, 4> table{
        // as Swinging has them
        {{"cycloid", cycloid}, {"arc", arc}, {"reach", reach}, {"creep", creep}}};
    return table;
}

const StridePath* find_stride_path(std::string_view name) noexcept {
    const auto all = stride_paths();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const StridePath& p) { return p.name == name; });
    return found == all.end() ? nullptr : &*found;
}

const StridePath& path_of(Swinging what) noexcept { return stride_paths()[static_cast<std::size_t>(what)]; }

Vec3 foot_at(const StridePath& path, const Swing& swing, double progress) noexcept {
    if (!(progress > 0)) return swing.start;
    if (progress >= 1) return swing.end;
    const SwingPoint point = path.point(progress);
    const Vec3 way = swing.end - swing.start;
    const Vec3 along = unit_or(way);
    // The ups of both ends, turned into the plane of the stride.
    const Vec3 up = unit_or(across((1 - point.along) * swing.start_up + point.along * swing.end_up, along));
    const Vec3 first = unit_or(across(swing.start_up, along));
    const Vec3 rise = up == Vec3{} ? first : up;
    return swing.start + point.along * way + swing.height * point.height * rise;
}

}  // namespace orbweaver::spider
