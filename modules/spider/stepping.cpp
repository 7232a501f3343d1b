#include "stepping.hpp"

#include <algorithm>
#include <cmath>

#include "aim.hpp"
#include "rotor.hpp"
#include "unit.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kMostStretch = 0.96;  // of a leg's length, of a foothold
constexpr double kStrained = 0.97;     // of a leg's length: it steps out of turn
constexpr double kOffHome = 1.3;       // of half a stride's excursion: the same
constexpr double kLandingTime = 0.12;  // s
constexpr double kTurnRate = 0.5;      // of a cycle a second, of gaits that change
constexpr double kLift = 0.3;          // of the body's height, of a swing

GaitState gait_state(const Conduct& conduct, CreatureState& state) noexcept {
    const std::size_t legs = conduct.species->limbs.size();
    return {&state.phase, std::span(state.start).first(legs), std::span(state.progress).first(legs)};
}

/// A creature in one frame, and how it goes.
struct Stepping {
    const Surface& surface;
    const Conduct& conduct;
    CreatureState& state;
    CreatureMeasures& measures;
    BodyPose body;
    Pace pace;
    double speed = 0;  ///< m/s
    Vec3 way;          ///< unit; nothing: it stands

    Stepping(const Surface& on, const Conduct& how, CreatureState& who, CreatureMeasures& counts) noexcept
        : surface(on),
          conduct(how),
          state(who),
          measures(counts),
          body(pose_of(how, who)),
          speed(norm(who.ground.velocity)) {
        // Feet move against a body that turns as they do against one that walks.
        pace = pace_at(how.pace, speed + std::abs(who.spin) * how.species->stance_radius);
        way = unit_or(who.ground.velocity);
    }
    const Limb& limb(std::size_t leg) const noexcept { return conduct.species->limbs[leg]; }
    std::size_t legs() const noexcept { return conduct.species->limbs.size(); }
};

/// Where the body will be in `time` s, if it goes on as it does.
BodyPose body_in(const Stepping& walk, double time) noexcept {
    BodyPose body = walk.body;
    const Rotor<double> turn = rotor(std::clamp(walk.state.spin * time, -1.0, 1.0));
    body.position += walk.speed * time * walk.way;
    body.forward = turn.c * walk.body.forward - turn.s * walk.body.right;
    body.right = turn.c * walk.body.right + turn.s * walk.body.forward;
    return body;
}

/// s, of the whole cycle: how long a foot that lifts now is in the air, and stands then.
struct StepTimes {
    double swing = 0, stance = 0;
};
StepTimes step_times(const Pace& pace) noexcept {
    if (!(pace.frequency > 0)) return {};
    constexpr double kLongest = 2 * kLandingTime;  // foreseen
    return {std::min((1 - pace.duty) / pace.frequency, kLandingTime),
            std::min(pace.duty / pace.frequency, kLongest)};
}

/// For a foot at a place of the body's frame. Its last bone, for a solver that cares, lies as at rest, in the
/// plane through root and foot: one that no leg's plane has is out of reach.
LegTarget target_at(const Conduct& conduct, const Limb& limb, const Vec3& place) noexcept {
    LegTarget target{to_limb(limb, place)};
    if (!conduct.solver->orients) return target;
    LegPose facing = rest_pose(limb.leg);
    face(limb.leg, target.position, foot_side(limb.leg, facing), facing);
    target.orientation = foot_frame(limb.leg, facing);
    return target;
}

Foothold foothold_for(const Stepping& walk, const Limb& limb, const Vec3& wanted, const BodyPose& landing,
                      double search) noexcept {
    LegSolverOptions options;
    options.restarts = 2;      // a place that takes more is not worth it: there are others
    options.tolerance = 1e-3;  // that it reaches is all that is asked
    const auto serves = [&](const Foothold& hold) {
        if (!holds(walk.surface.grip(hold.at.face), hold.up, walk.conduct.gravity)) return false;
        if (distance(hold.position, to_world(landing, limb.base)) > kMostStretch * limb.leg.length)
            return false;
        LegPose pose = rest_pose(limb.leg);
        const LegTarget target = target_at(walk.conduct, limb, from_world(landing, hold.position));
        return walk.conduct.solver->solve(limb.leg, target, options, pose).answer == LegAnswer::reached;
    };
    return find_foothold(walk.surface, walk.conduct.footholds, walk.state.ground.footing, walk.body.up, wanted,
                         limb.leg.length, search, serves);
}

/// Where a foot that has found nothing feels about next: round and round where it would like to stand, and each
/// time on a wider ring, up to its leg's reach.
Vec3 searched_place(const Stepping& walk, const Limb& limb, const Foot& foot, const Vec3& wanted,
                    double search) noexcept {
    constexpr int kOnwards = 3;  // of the eight places on a ring
    const int number = 1 + static_cast<int>(foot.searches * kOnwards % (kFootholdTries - 1));
    const Vec3 place = foothold_try(number, walk.state.ground.footing, wanted, search) +
                       kLift * walk.conduct.species->height * walk.body.up;
    const Vec3 base = to_world(walk.body, limb.base);
    const double reach = 0.9 * limb.leg.length, away = distance(place, base);
    return away > reach ? base + (reach / away) * (place - base) : place;
}

/// What a swing is for: to feel about where no foothold was found, to hunt unseen, to run, or just to walk.
Swinging purpose_of(const Stepping& walk, bool found) noexcept {
    constexpr double kStalks = 0.5, kRuns = 0.8;  // of its top speed
    const Behaviors& wants = walk.conduct.behaviors;
    const double top = walk.conduct.pace.top_speed;
    if (!found) return Swinging::searches;
    if (wants.pursue > 0 && walk.speed < kStalks * top) return Swinging::stalks;
    const bool hurries = wants.pursue > 0 || wants.evade > 0 || wants.flee.weight > 0;
    return hurries && walk.speed > kRuns * top ? Swinging::runs : Swinging::walks;
}

/// To a foothold that it finds, or on searching: each time farther about, up to twice as far.
void begin_swing(const Stepping& walk, std::size_t leg) noexcept {
    constexpr double kSearch = 0.4;  // of the leg's length
    const Limb& limb = walk.limb(leg);
    Foot& foot = walk.state.feet[leg];
    const StepTimes times = step_times(walk.pace);
    const double search = kSearch * limb.leg.length * (1 + std::min(foot.searches, 4U) / 4.0);
    const BodyPose middle = body_in(walk, times.swing + times.stance / 2);
    const Vec3 wanted = to_world(middle, limb.stance);
    const Foothold hold = foothold_for(walk, limb, wanted, body_in(walk, times.swing), search);
    foot.searches = hold.found ? 0 : foot.searches + 1;
    ++(hold.found ? walk.measures.steps : walk.measures.searches);
    foot.holds = hold.found;
    foot.rim = hold.rim;
    foot.home = hold.found ? from_world(middle, hold.position) : limb.stance;
    const StridePath& path =
        walk.conduct.path != nullptr ? *walk.conduct.path : path_of(purpose_of(walk, hold.found));
    foot.path = static_cast<std::uint32_t>(&path - stride_paths().data());
    foot.swing.start = foot.place;
    foot.swing.start_up = walk.body.up;
    foot.swing.end = hold.found ? hold.position : searched_place(walk, limb, foot, wanted, search);
    foot.swing.end_up = hold.found ? hold.up : walk.body.up;
    foot.swing.height = kLift * walk.conduct.species->height + 0.1 * distance(foot.swing.start, foot.swing.end);
    walk.state.progress[leg] = std::max(walk.state.progress[leg], 0.0);
}

/// Feet as the gait sees them that cares for balance.
void look_at_balance(const Stepping& walk, std::span<SupportPoint> feet, SupportPoint& velocity) noexcept {
    const Vec3& middle = walk.conduct.species->shape.center_of_mass;
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        const Vec3 place = from_world(walk.body, walk.state.feet[leg].place) - middle;
        feet[leg] = {place.x, place.z};
    }
    velocity = {walk.speed * dot(walk.way, walk.body.forward), walk.speed * dot(walk.way, walk.body.right)};
}

void advance_swings(const Stepping& walk, const RandomStream& random, double dt) noexcept {
    constexpr std::uint64_t kOwnDraws = std::uint64_t{1}
                                        << 41;  // the stream is the creature's: see follow_wall()
    std::array<std::uint8_t, kMaxLegs> strained{}, lifted{}, landed{};
    std::array<SupportPoint, kMaxLegs> feet;
    CreatureState& state = walk.state;
    state.strain = 0;
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        if (state.progress[leg] >= 0) continue;
        const double strain = strain_of(walk.limb(leg), walk.body, walk.pace, state.feet[leg]);
        strained[leg] = strain > 1 ? 1 : 0;
        state.strain = std::max(state.strain, strain);
    }
    GaitTick tick;
    tick.dt = dt;
    tick.landing_time = kLandingTime;
    tick.turn_rate = kTurnRate;
    tick.strained = std::span(strained).first(walk.legs());
    tick.lifted = std::span(lifted).first(walk.legs());
    tick.landed = std::span(landed).first(walk.legs());
    look_at_balance(walk, feet, tick.velocity);
    tick.feet = std::span(feet).first(walk.legs());
    tick.jitter = std::span(state.jitter).first(walk.legs());
    const GaitState gait = gait_state(walk.conduct, state);
    advance_gait(*walk.conduct.gait, walk.pace, tick, gait);
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        Foot& foot = state.feet[leg];
        if (lifted[leg] != 0)
            state.jitter[leg] = walk.conduct.jitter * random.uniform(kOwnDraws + state.jitter_draws++, -1, 1);
        if (landed[leg] != 0) foot.place = foot.swing.end;
        if (lifted[leg] != 0 || (landed[leg] != 0 && !foot.holds)) begin_swing(walk, leg);
        if (motion_of(gait, leg) == LegMotion::swings)
            foot.place = foot_at(stride_paths()[foot.path], foot.swing, gait.progress[leg]);
    }
}

using LegResults = std::array<LegResult, kMaxLegs>;

LegTarget target_of(const Stepping& walk, std::size_t leg) noexcept {
    return target_at(walk.conduct, walk.limb(leg), from_world(walk.body, walk.state.feet[leg].place));
}

LegResults solve_one_by_one(const Stepping& walk) noexcept {
    LegResults results;
    for (std::size_t leg = 0; leg < walk.legs(); ++leg)
        results[leg] =
            walk.conduct.solver->solve(walk.limb(leg).leg, target_of(walk, leg), {}, walk.state.poses[leg]);
    return results;
}

LegResults solve_side_by_side(const Stepping& walk) noexcept {
    const LegLanes& lanes = *walk.conduct.lanes;
    std::array<double, kMaxLegs * kJoints> angles;
    std::array<double, kMaxLegs * 3> targets;
    angles.fill(0);
    targets.fill(0);
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        lanes.set_pose(angles, leg, walk.state.poses[leg]);
        lanes.set_target(targets, leg, target_of(walk, leg).position);
    }
    LegResults results;
    lanes.solve(targets, {}, angles, results);
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) walk.state.poses[leg] = lanes.pose(angles, leg);
    return results;
}

void reach_feet(const Stepping& walk) noexcept {
    const LegResults results =
        walk.conduct.lanes != nullptr ? solve_side_by_side(walk) : solve_one_by_one(walk);
    CreatureMeasures& measures = walk.measures;
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        const Limb& limb = walk.limb(leg);
        const LegPose& pose = walk.state.poses[leg];
        measures.worst_joint = std::max(measures.worst_joint, violation(limb.leg, pose));
        if (walk.state.progress[leg] >= 0) continue;
        if (results[leg].answer == LegAnswer::reached) {
            ++measures.feet_down;
            measures.worst_reach = std::max(measures.worst_reach, results[leg].error / limb.leg.length);
            continue;
        }
        // Rather than be torn off, the foot lifts from where the leg still is.
        walk.state.feet[leg].place = to_world(walk.body, to_body(limb, foot_position(limb.leg, pose)));
        begin_swing(walk, leg);
        ++measures.forced_steps;
    }
}

}  // namespace

double strain_of(const Limb& limb, const BodyPose& body, const Pace& pace, const Foot& foot) noexcept {
    const Vec3 place = from_world(body, foot.place);
    const double stretch = distance(place, limb.base) / (kStrained * limb.leg.length);
    const double off = distance(place, foot.home);
    return std::max(stretch, off / (kOffHome * pace.duty * pace.stride / 2 + 0.15 * limb.leg.length));
}

void place_feet(const Surface& surface, const Conduct& conduct, CreatureState& state) noexcept {
    begin_gait(*conduct.gait, gait_state(conduct, state));
    CreatureMeasures unused;
    const Stepping walk(surface, conduct, state, unused);
    for (std::size_t leg = 0; leg < walk.legs(); ++leg) {
        Foot& foot = state.feet[leg];
        state.poses[leg] = rest_pose(walk.limb(leg).leg);
        foot.place = to_world(walk.body, walk.limb(leg).stance);
        begin_swing(walk, leg);
        if (!foot.holds) continue;
        foot.place = foot.swing.end;
        state.progress[leg] = -1;
    }
    reach_feet(walk);
}

void step_feet(const Surface& surface, const Conduct& conduct, const RandomStream& random, double dt,
               CreatureState& state, CreatureMeasures& measures) noexcept {
    const Stepping walk(surface, conduct, state, measures);
    advance_swings(walk, random, dt);
    reach_feet(walk);
}

}  // namespace orbweaver::spider
