#pragma once

#include <cstddef>
#include <cstring>

#include "friction.hpp"
#include "ground.hpp"
#include "mass_spring/lanes.hpp"
#include "touch.hpp"

/// The ground meets points, four at once: the same two neighboring corners of two rings, which as a rule are on
/// the ground together, or are not.
namespace orbweaver::crawler {

using mass_spring::sum;
using mass_spring::Vec3Lanes;

/// Where four points are in the planes of a vector (see Packing): at a and after it, at b and after it.
struct Four {
    std::size_t plane, a, b;

    ORBWEAVER_INLINE Lanes get(const double* from) const noexcept {
        Pair first, second;
        std::memcpy(&first, from + a, sizeof first);
        std::memcpy(&second, from + b, sizeof second);
        return __builtin_shufflevector(first, second, 0, 1, 2, 3);
    }
    ORBWEAVER_INLINE Vec3Lanes get_vectors(const double* from) const noexcept {
        return {get(from), get(from + plane), get(from + 2 * plane)};
    }
    ORBWEAVER_INLINE void put(const Lanes& what, double* to) const noexcept {
        const Pair first = __builtin_shufflevector(what, what, 0, 1);
        const Pair second = __builtin_shufflevector(what, what, 2, 3);
        std::memcpy(to + a, &first, sizeof first);
        std::memcpy(to + b, &second, sizeof second);
    }
    ORBWEAVER_INLINE void put_vectors(const Vec3Lanes& what, double* to) const noexcept {
        put(what.x, to), put(what.y, to + plane), put(what.z, to + 2 * plane);
    }
    std::size_t point(std::size_t lane) const noexcept { return (lane < 2 ? a : b) + lane % 2; }

private:
    using Pair = double __attribute__((vector_size(16)));
};

ORBWEAVER_INLINE Vec3Lanes either(const LaneBits& first, const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}
ORBWEAVER_INLINE Vec3Lanes crossed(const Vec3Lanes& a, const Vec3Lanes& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Four points with regard to the ground.
struct Touches {
    Lanes depth;       ///< m
    Vec3Lanes normal;  ///< unit
    Lanes grip;
};

template <class AnyGround>
ORBWEAVER_INLINE Touches touch_all(const AnyGround& ground, const Vec3Lanes& x, const Four& four) noexcept {
    Touches all;
    for (std::size_t j = 0; j < 4; ++j) {
        const Touch touch = ground.touch({x.x[j], x.y[j], x.z[j]}, four.point(j));
        all.depth[j] = touch.depth;
        all.normal.x[j] = touch.normal.x, all.normal.y[j] = touch.normal.y, all.normal.z[j] = touch.normal.z;
        all.grip[j] = touch.grip;
    }
    return all;
}

ORBWEAVER_INLINE Touches touch_all(const Floor& floor, const Vec3Lanes& x, const Four&) noexcept {
    return {floor.depth(x.y), {Lanes{}, in_all(1), Lanes{}}, in_all(1)};
}

/// In the plane across a normal, of length 1. Where it has nothing there, nothing tells forward from sideways.
ORBWEAVER_INLINE Vec3Lanes laid_across(const Vec3Lanes& spine, const Vec3Lanes& normal) noexcept {
    const Vec3Lanes along = spine - normal * dot(spine, normal);
    const Lanes square = dot(along, along);
    const LaneBits has_one = square > Lanes{};
    if (!is_any(~has_one)) return along * (1 / mass_spring::sqrt(square));
    const LaneBits is_steep = absolute(normal.x) < in_all(0.5);
    const Vec3Lanes axis{is_steep ? in_all(1) : Lanes{}, Lanes{}, is_steep ? Lanes{} : in_all(1)};
    const Vec3Lanes chosen = either(has_one, along, axis - normal * dot(axis, normal));
    return chosen * (1 / mass_spring::sqrt(dot(chosen, chosen)));
}

/// Four points after a step of h seconds.
struct Landing {
    Vec3Lanes x, v;        ///< m, m/s
    Vec3Lanes start;       ///< m, before the step
    Vec3Lanes start_v;     ///< m/s
    Vec3Lanes pressed;     ///< m/s, what the ground's reaction gave them during the step
    Vec3Lanes turned;      ///< m/s, what the ground gave them at the end of the step before, after their way
    Vec3Lanes spine;       ///< along their body, of any length
    Lanes holds;           ///< m/s, what it takes to tear them off
    double allowance = 0;  ///< m, deep in the ground within which they may stay
    Vec3 weighed;          ///< m/s, what gravity gives them in a step
    double lag = 0;        ///< of the method (see MethodInfo), where its forces act where steps begin; else 0
    double velocity_lag = 0;  ///< of the method
    bool are_damped = false;  ///< their springs are
};

/// Per kg, and what goes with it; of each lane.
struct LandingBooks {
    Lanes friction{}, impact{}, slip{}, contacts{};
    /// Less of impact, what the ground gave by lifting them, one step late in part. A reaction that ceases at
    /// once counts too.
    Lanes lift{};
    Lanes damping{};  ///< what springs' damping took as falls ended
    Lanes lagging{};  ///< of the work in friction and impact, what a method's lag put there

    /// The last two lanes only where they are not the first two again.
    ORBWEAVER_INLINE void add(const LandingBooks& more, bool all) noexcept {
        const Lanes counts = all ? in_all(1) : Lanes{1, 1, 0, 0};
        friction += counts * more.friction;
        impact += counts * more.impact;
        slip += counts * more.slip;
        contacts += counts * more.contacts;
        lift += counts * more.lift;
        damping += counts * more.damping;
        lagging += counts * more.lagging;
    }
};

/// Those that `are_on` the ground are met by it; others were left by it during the step, if it pressed them.
///
/// What presses during a step works on its way, and an impulse on the mean of the velocities before and after
/// it. Where forces act where a step begins, they work half on the way before and half on the way after: the
/// reaction works on the mean of its velocities then. Energy is kept with velocities as they are at the time of
/// positions: what turns or lifts a point there has its part of what all else gives it in the step.
ORBWEAVER_INLINE void meet_ground(const Touches& touch, const LaneBits& are_on, const Friction& friction,
                                  double h, Landing& points, LandingBooks& books) noexcept {
    const Vec3Lanes n = touch.normal, moved = points.x - points.start;
    const Vec3Lanes spine = laid_across(points.spine, n), side = crossed(n, spine);
    const Vec3Lanes given = points.v - points.start_v - points.pressed;  // by all but the ground
    const Lanes into = dot(points.v, n), pressed = dot(points.pressed, n);
    const Lanes given_up = dot(given, n), turned_up = dot(points.turned, n);
    const Vec3Lanes along = points.v - n * into, held = points.pressed - n * pressed;
    // What is within the reach of its feet alone is held, but not pushed.
    const Lanes asked = larger_of(-points.holds, pressed - into);
    const Lanes pressing = (asked > Lanes{}) & (touch.depth <= in_all(-points.allowance)) ? Lanes{} : asked;
    const Lanes left = into + pressing - pressed;
    const Vec3Lanes free = along - held;  // without friction
    const Sliding slid = slide(friction, touch.grip * (pressing + points.holds),
                               {are_on ? dot(free, spine) : Lanes{}, are_on ? dot(free, side) : Lanes{}},
                               mass_spring::sqrt(dot(points.start_v, points.start_v)));
    const Vec3Lanes slides = spine * slid.along + side * slid.across;
    const Lanes lifted = larger_of(touch.depth - points.allowance, Lanes{}), lift = lifted * (1 / h);
    // What all but the ground gave them into the ground; the rest of what is taken is their fall, which ends
    // here: the ground goes on to press as it does without.
    const Lanes share = pressing > Lanes{} ? -given_up / pressing : in_all(1);
    const Lanes lasting = larger_of(Lanes{}, share < 1 ? share : in_all(1));
    // What ended a fall turned them by more than the ground presses by since. It stopped at once what springs
    // then brake, unstrained as yet: what they gave them in the step is damping's, to first order.
    const Vec3& weighed = points.weighed;
    const Lanes braked = given_up - (weighed.x * n.x + weighed.y * n.y + weighed.z * n.z);
    const Lanes fell = larger_of(Lanes{}, turned_up - absolute(pressed));
    const double lag = points.lag, turned_lag = points.velocity_lag;
    const Lanes fell_lag = points.are_damped ? turned_lag * braked * fell : Lanes{};
    const Vec3Lanes speed = moved * in_all(1 / h);                      // of the way
    const Vec3Lanes later = points.start_v + points.v - speed - speed;  // twice what the mean velocity has more
    const Lanes held_lag = turned_lag * dot(given, points.turned - n * turned_up) + lag * dot(held, later);
    const Lanes lifted_by = are_on ? lift : Lanes{};
    const Lanes pressed_lag =
        turned_lag * given_up * (turned_up + lifted_by) + lag * pressed * dot(later, n) - fell_lag;
    const Lanes slide_work = 0.5 * (dot(slides, slides) - dot(along, along));
    const Lanes landing_work = 0.5 * (left * left - into * into) - given_up * lift;
    const Vec3Lanes slip = moved - n * dot(moved, n);
    books.friction -= dot(held, speed) + held_lag + (are_on ? slide_work : Lanes{});
    books.impact -= pressed * dot(speed, n) + pressed_lag + (are_on ? landing_work : Lanes{});
    books.lift -= given_up * ((1 - turned_lag) * lifted_by + turned_lag * larger_of(Lanes{}, -turned_up));
    books.damping -= fell_lag;
    books.lagging += held_lag + pressed_lag;
    books.slip += are_on ? mass_spring::sqrt(dot(slip, slip)) : Lanes{};
    books.contacts += are_on ? in_all(1) : Lanes{};
    points.x = either(are_on, points.x + n * lifted, points.x);
    points.v = either(are_on, slides + n * left, points.v);
    points.turned = either(are_on, slides - along + n * (pressing - pressed - lift), Vec3Lanes{});
    points.pressed = either(are_on, (n * pressing + slides - free) * lasting, Vec3Lanes{});
}

}  // namespace orbweaver::crawler
