#include "keep_off.hpp"

#include <algorithm>
#include <array>

#include "ground.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kRounding = 1e-9;  // relative; of what is surely free
constexpr double kSpare = 0.003;    // of the height above the ground, more than clear that a body is moved

/// The deepest ball: how deep (below 0: clear), and the way out (unit).
struct Overlap {
    double depth = 0;
    Vec3 way;
};

/// What is known to be free of surface about one body, on the side that its creature is on: open balls that
/// hang together with each other. They spare most questions: a ball within one of them is clear.
class FreeSpace {
public:
    void add(const Vec3& center, double radius) noexcept {
        known_[count_++ % known_.size()] = {center, radius};
    }
    bool holds(const Vec3& center, double radius) const noexcept {
        return any([&](const Ball& each) {
            return distance(each.center, center) + radius <= each.radius * (1 - kRounding);
        });
    }
    /// Whether a free ball there is on this side for sure.
    bool touches(const Vec3& center, double radius) const noexcept {
        return any([&](const Ball& each) {
            return distance(each.center, center) < (each.radius + radius) * (1 - kRounding);
        });
    }

private:
    template <class Test>
    bool any(const Test& test) const noexcept {
        return std::any_of(known_.begin(), known_.begin() + static_cast<std::ptrdiff_t>(size()), test);
    }
    std::size_t size() const noexcept { return std::min(count_, known_.size()); }

    std::array<Ball, 16> known_;
    std::size_t count_ = 0;
};

class Prober {
public:
    Prober(const Surface& surface, const BodyShape& shape, const Footing& ground) noexcept
        : surface_(surface), shape_(shape), ground_(ground) {}

    Overlap deepest(const BodyPose& pose) noexcept {
        deepest_ = {};
        root_ = to_world(pose, shape_.parts[0].around.center);
        if (!root_is_free()) return deepest_;
        const Rotor<double> bend = rotor(pose.bend);
        const auto straight = [&](const Vec3& point) { return to_world(pose, point); };
        probe(shape_.parts[0], pose.up, straight);
        probe(shape_.parts[1], pose.up, straight);
        probe(shape_.parts[2], pose.up,
              [&](const Vec3& point) { return to_world(pose, bent(shape_, bend, point)); });
        return deepest_;
    }

private:
    /// The thorax's middle, seen from next to where the creature stands.
    bool root_is_free() noexcept {
        constexpr double kOff = 1e-3;  // of the height, so that nothing begins in the ground
        const double height = distance(root_, ground_.position);
        const Vec3 start = next_to(surface_, ground_, kOff * height);
        space_.add(start, 0);
        return look(start, root_, shape_.parts[0].balls[0].radius, height) >= 0;
    }

    /// `place(point)` is where a point of the body's frame is.
    template <class Place>
    void probe(const BodyPart& part, const Vec3& up, const Place& place) noexcept {
        const double reach = part.around.radius;
        const Vec3 middle = place(part.around.center);
        if (space_.holds(middle, reach) || look(root_, middle, part.balls[0].radius, reach) >= reach) return;
        look_from_above(middle, up, reach);
        for (const Ball& ball : part.balls) {
            const Vec3 center = place(ball.center);
            if (!space_.holds(center, ball.radius)) look(root_, center, ball.radius, reach);
        }
    }

    /// Over level ground a large free ball from above holds what lies flat beneath it.
    void look_from_above(const Vec3& middle, const Vec3& up, double reach) noexcept {
        const Vec3 high = middle + 2 * reach * up;
        const SurfaceHit near = surface_.closest_point(high, 3 * reach);
        const double free = near.answer == Answer::found ? near.distance : 3 * reach;
        if (space_.touches(high, free)) space_.add(high, free);
    }

    /// m, from the middle of a ball to the surface, or `reach` if it is farther; -1 where it is beyond, seen
    /// from a free place. What overlaps is noted.
    double look(const Vec3& from, const Vec3& center, double radius, double reach) noexcept {
        const SurfaceHit near = surface_.closest_point(center, reach);
        const double free = near.answer == Answer::found ? near.distance : reach;
        if (!space_.touches(center, free) && hides(from, center, radius)) return -1;
        space_.add(center, free);
        if (free < radius && free > 0) note(radius - free, (center - surface_.position(near.at)) / free);
        return free;
    }

    /// Whether the surface lies between `from`, which is free, and `to`: then a ball there is below it.
    bool hides(const Vec3& from, const Vec3& to, double radius) noexcept {
        const SurfaceHit hit = surface_.first_hit({from, to - from, 1});
        if (hit.answer != Answer::found) return false;
        const Vec3 normal = surface_.normal(hit.at.face);
        const double below = dot(normal, surface_.position(hit.at) - to);
        note(radius + (below < 0 ? -below : below), below < 0 ? -1 * normal : normal);
        return true;
    }

    void note(double depth, const Vec3& way) noexcept {
        if (depth > deepest_.depth) deepest_ = {depth, way};
    }

    const Surface& surface_;
    const BodyShape& shape_;
    const Footing& ground_;
    FreeSpace space_;
    Vec3 root_;
    Overlap deepest_;
};

BodyPose shifted(BodyPose pose, const Vec3& shift) noexcept {
    pose.position += shift;
    return pose;
}

}  // namespace

double penetration(const Surface& surface, const BodyShape& shape, const Footing& ground,
                   const BodyPose& pose) noexcept {
    return Prober(surface, shape, ground).deepest(pose).depth;
}

double keep_off(const Surface& surface, const BodyShape& shape, const Footing& ground,
                const BodyPose& unshifted, double most, Vec3& shift) noexcept {
    constexpr int kPushes = 40;
    constexpr double kGrowth =
        1.05;  // of each push over the one before: who goes to and fro gets out in the end
    const double spare = kSpare * distance(unshifted.position, ground.position);
    Prober prober(surface, shape, ground);
    Overlap overlap = prober.deepest(shifted(unshifted, shift));
    double grown = 1;
    for (int i = 0; i < kPushes && overlap.depth > 0; ++i) {
        shift += (grown * overlap.depth + spare) * overlap.way;
        grown *= kGrowth;
        const double length = norm(shift);
        if (length > most) shift *= most / length;
        overlap = prober.deepest(shifted(unshifted, shift));
    }
    return overlap.depth;
}

}  // namespace orbweaver::spider
