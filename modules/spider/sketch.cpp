#include "sketch.hpp"

#include <algorithm>
#include <utility>

namespace orbweaver::spider {
namespace {

using Color = std::array<float, 3>;
constexpr Color kUnderfoot{1, 0.85F, 0.1F}, kFelt{0.2F, 0.85F, 1}, kSupport{1, 1, 1},
    kStands{0.25F, 0.95F, 0.3F}, kSwings{1, 0.55F, 0.1F}, kEmpty{1, 0.1F, 0.1F};

/// Draws with one color.
class Pen {
public:
    Pen(std::vector<SketchLine>& lines, const Color& color) : lines_(lines), color_(color) {}
    void line(const Vec3& a, const Vec3& b) { lines_.push_back({a, b, color_}); }
    /// A square across `up`, standing on a corner.
    void mark(const Vec3& at, const Vec3& up, double size) {
        const Vec3 side = std::abs(up.y) < 0.9 ? cross(up, {0, 1, 0}) : cross(up, {1, 0, 0});
        const Vec3 x = size / norm(side) * side, y = cross(up, x);
        for (const auto& [a, b] : {std::pair{x, y}, {y, -1 * x}, {-1 * x, -1 * y}, {-1 * y, x}})
            line(at + a, at + b);
    }

private:
    std::vector<SketchLine>& lines_;
    Color color_;
};

/// Edges of the polygon that a face is part of; those within it are passed twice.
void draw_polygon(const Surface& surface, std::uint32_t face, Pen pen) {
    const auto faces = surface.faces();
    const auto polygons = surface.polygons();
    std::size_t first = face, end = face + 1;
    while (first > 0 && polygons[first - 1] == polygons[face]) --first;
    while (end < faces.size() && polygons[end] == polygons[face]) ++end;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t f = first; f < end; ++f)
        for (std::size_t e = 0; e < 3; ++e) edges.emplace_back(std::minmax(faces[f][e], faces[f][(e + 1) % 3]));
    std::sort(edges.begin(), edges.end());
    for (const auto& edge : edges)
        if (std::upper_bound(edges.begin(), edges.end(), edge) -
                std::lower_bound(edges.begin(), edges.end(), edge) ==
            1)
            pen.line(surface.vertices()[edge.first], surface.vertices()[edge.second]);
}

/// Along the surface, as feel_ahead() goes.
void draw_feel(const Surface& surface, const Conduct& conduct, const Ground& ground, Pen pen) {
    constexpr int kPieces = 12;
    const double reach = feel_reach(*conduct.species);
    for (const double way : {1.0, -1.0}) {
        Vec3 last = ground.footing.position;
        for (int i = 1; i <= kPieces; ++i) {
            const SurfaceStep step =
                stride_along(surface, ground.footing, way * ground.facing, reach * i / kPieces).step;
            if (step.answer != Answer::found) break;
            pen.line(last, step.end.position);
            last = step.end.position;
        }
        pen.mark(last, ground.footing.up, 0.03 * reach);
    }
    const Feel feel = feel_ground(surface, *conduct.species, ground);
    pen.line(ground.footing.position, ground.footing.position + 0.6 * reach * feel.up);
}

/// Legs are numbered in pairs from front to back; this goes around: R1 R2 ... L2 L1.
std::size_t around(std::size_t i, std::size_t legs) noexcept {
    return i < legs / 2 ? 2 * i : 2 * (legs - 1 - i) + 1;
}

void draw_support(const Conduct& conduct, const CreatureState& state, double size, Pen pen) {
    const std::size_t legs = conduct.species->limbs.size();
    std::vector<Vec3> feet;
    for (std::size_t i = 0; i < legs; ++i) {
        const std::size_t leg = around(i, legs);
        if (state.progress[leg] < 0 && state.feet[leg].holds) feet.push_back(state.feet[leg].place);
    }
    for (std::size_t i = 0; i < feet.size(); ++i) pen.line(feet[i], feet[(i + 1) % feet.size()]);
    const BodyPose body = pose_of(conduct, state);
    const Vec3 below = body.position - conduct.species->height * body.up;
    pen.line(body.position, below);
    pen.mark(below, body.up, size);
}

void draw_foot(const Foot& foot, double progress, double size, std::vector<SketchLine>& lines) {
    constexpr int kPieces = 12;
    if (progress < 0)
        return Pen(lines, foot.holds ? kStands : kEmpty).mark(foot.place, foot.swing.end_up, size);
    Pen pen(lines, foot.holds ? kSwings : kEmpty);
    for (int i = 0; i < kPieces; ++i)
        pen.line(foot_at(stride_paths()[foot.path], foot.swing, static_cast<double>(i) / kPieces),
                 foot_at(stride_paths()[foot.path], foot.swing, static_cast<double>(i + 1) / kPieces));
    pen.mark(foot.swing.end, foot.swing.end_up, size);
    pen.line(foot.swing.end - 2 * size * foot.swing.end_up, foot.swing.end + 5 * size * foot.swing.end_up);
}

/// How far joint j is from comfort (0) to its limit (1).
double discomfort(const Leg& leg, const LegPose& pose, std::size_t j) noexcept {
    return std::clamp(std::max((pose[j] - leg.comfort_max[j]) * leg.per_above[j],
                               (pose[j] - leg.comfort_min[j]) * leg.per_below[j]),
                      0.0, 1.0);
}

void draw_leg(const BodyPose& body, const Limb& limb, const LegPose& pose, std::vector<SketchLine>& lines) {
    const auto joints = joint_positions(limb.leg, pose);
    for (std::size_t i = 0; i < kBones; ++i) {
        if (limb.leg.bone[i] == 0) continue;
        double most = discomfort(limb.leg, pose, kPitch + i);
        if (i == 0)
            most = std::max({most, discomfort(limb.leg, pose, kYaw), discomfort(limb.leg, pose, kTilt)});
        const auto red = static_cast<float>(std::min(1.0, 2 * most)),
                   green = static_cast<float>(std::min(1.0, 2 - 2 * most));
        Pen(lines, {0.15F + 0.85F * red, 0.85F * green, 0.15F})
            .line(to_world(body, to_body(limb, joints[i])), to_world(body, to_body(limb, joints[i + 1])));
    }
}

}  // namespace

void add_sketch(const Surface& surface, const Conduct& conduct, const CreatureState& state,
                std::vector<SketchLine>& lines) {
    const double size = 0.03 * mean_leg_length(*conduct.species);
    const BodyPose body = pose_of(conduct, state);
    draw_polygon(surface, state.ground.footing.at.face, Pen(lines, kUnderfoot));
    draw_feel(surface, conduct, state.ground, Pen(lines, kFelt));
    draw_support(conduct, state, size, Pen(lines, kSupport));
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
        draw_leg(body, conduct.species->limbs[leg], state.poses[leg], lines);
        draw_foot(state.feet[leg], state.progress[leg], size, lines);
    }
}

}  // namespace orbweaver::spider
