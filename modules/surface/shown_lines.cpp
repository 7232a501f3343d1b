#include "shown_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace orbweaver::surface {

namespace {

constexpr double kFineness = 1e-2;  // of the surface's size: pieces of a line, each straight in the picture
constexpr double kPieces = 10'000;  // at most, of one line
constexpr double kAbove = 2e-3;     // of the size, so that a face does not hide what lies on it

void report(Host& host, const std::string& name, const char* key, const std::string& what,
            const char* expected) {
    const Location where = host.options().where("line." + name + "." + key);
    host.report_fault({where, "line '" + name + "' " + what, expected, ""});
}

}  // namespace

std::span<const std::string_view> ShownLines::kinds() const noexcept {
    static constexpr std::array<std::string_view, 1> kKinds{"line"};
    return kKinds;
}

void ShownLines::draw(const Surface& surface, Host& host) {
    const Options& options = host.options();
    for (const std::string& name : options.names_in("line")) {
        const std::string prefix = "line." + name + ".";
        bool whole = true;
        for (const char* key : {"from", "along", "length"}) {
            if (options.has(prefix + key)) continue;
            report(host, name, key, std::string("has no '") + key + "'", "'from', 'along' and 'length'");
            whole = false;
        }
        if (!whole) continue;
        const Vec3& from = options.vector(prefix + "from");
        const SurfaceHit near = surface.closest_point(from, std::numeric_limits<double>::infinity());
        const Vec3 normal = surface.normal(near.at.face);
        const Vec3 up = dot(from - surface.position(near.at), normal) < 0 ? -normal : normal;
        const SurfaceStep placed = surface.place(near.at, up, options.vector(prefix + "along"));
        if (placed.answer == Answer::found)
            walk(surface, placed.end, options.number(prefix + "length"));
        else
            report(host, name, "along", "points out of the surface", "a direction along it");
    }
}

void ShownLines::walk(const Surface& surface, Footing at, double length) {
    const double wanted = std::ceil(length / (kFineness * surface.size()) - 1e-9);
    const int pieces = static_cast<int>(std::clamp(wanted, 1.0, kPieces));
    const auto keep = [&] { points_.push_back(at.position + kAbove * surface.size() * at.up); };
    keep();
    for (int i = 0; i < pieces; ++i) {
        const SurfaceStep step = surface.step(at, length / pieces);
        if (step.answer != Answer::found) return;
        at = step.end;
        keep();
        const auto last = static_cast<std::uint32_t>(points_.size() - 1);
        segments_.push_back({last - 1, last, 0});
        if (step.stop != StepStop::none) return;
    }
}

}  // namespace orbweaver::surface
