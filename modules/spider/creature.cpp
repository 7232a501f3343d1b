#include "creature.hpp"

#include <algorithm>
#include <cmath>

#include "open_way.hpp"
#include "orbweaver/exact_math.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kMostStretch = 0.96;  // of a leg's length, of a foothold
constexpr double kStrained = 0.97;     // of a leg's length: it steps out of turn
constexpr double kOffHome = 1.3;       // of half a stride's excursion: the same
constexpr double kLandingTime = 0.12;  // s
constexpr double kTurnRate = 0.5;      // of a cycle a second, of gaits that change
constexpr double kLift = 0.3;          // of the body's height, of a swing
constexpr double kForesight = 0.35;    // s, in which it sees borders coming and what no foot holds on

double body_length(const Species& species) noexcept {
    return species.body.head.x + species.body.thorax.x + species.body.abdomen.x;
}

/// Where a foot stands in the middle of its stance, body frame: where it is at rest, but near enough to reach
/// as far ahead as behind.
Vec3 stance_home(const Limb& limb) noexcept {
    constexpr double kStretch = 0.72;  // of the leg's length
    const Vec3 out = limb.home - limb.base;
    const double level = std::sqrt(out.x * out.x + out.z * out.z);
    const double least = kStretch * kStretch * limb.leg.length * limb.leg.length - out.y * out.y;
    const double wanted = least > 0 ? std::sqrt(least) : level;
    const double share = level > wanted ? wanted / level : 1;
    return limb.base + Vec3{share * out.x, out.y, share * out.z};
}

GaitState gait_state(const Conduct& conduct, CreatureState& state) noexcept {
    const std::size_t legs = conduct.species->limbs.size();
    return {&state.phase, std::span(state.start).first(legs), std::span(state.progress).first(legs)};
}

/// How much a standing leg is strained: 1 where it steps out of turn.
double strain_of(const Limb& limb, const BodyPose& body, const Pace& pace, const Foot& foot) noexcept {
    const Vec3 place = from_world(body, foot.place);
    const double stretch = distance(place, limb.base) / (kStrained * limb.leg.length);
    const double off = norm(across(place - stance_home(limb), {0, 1, 0}));
    return std::max(stretch, off / (kOffHome * pace.duty * pace.stride / 2 + 0.15 * limb.leg.length));
}

/// The part of its speed that a creature keeps which waits for its legs.
double patience(const Conduct& conduct, const CreatureState& state) noexcept {
    constexpr double kSlowest = 0.2;
    const BodyPose body = pose_of(conduct, state);
    const Pace pace = pace_at(conduct.pace, norm(state.ground.velocity));
    double most = 0;
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg)
        if (state.progress[leg] < 0 && state.feet[leg].holds)
            most = std::max(most, strain_of(conduct.species->limbs[leg], body, pace, state.feet[leg]));
    return std::clamp(1 - 3 * (most - 1.2), kSlowest, 1.0);
}

Vec3 wish(const Surface& surface, const Conduct& conduct, const Company& company, const Agent& agent,
          double reach, double dt, CreatureState& state, CreatureMeasures& measures) noexcept {
    const Behaviors& wants = conduct.behaviors;
    const double speed = norm(state.ground.velocity);
    const Vec3 ahead = speed > 0 ? state.ground.velocity / speed : state.ground.facing;
    Vec3 wandering, along_wall;
    if (wants.wander > 0) wandering = wander(agent, ahead, conduct.wander, company.random, dt, state.wander);
    if (wants.follow_wall > 0)
        along_wall =
            follow_wall(surface, state.ground, agent, reach, wants.walls, company.random, dt, state.wall);
    const Footing& footing = state.ground.footing;
    const Vec3 wanted = combined(wants, agent, footing.at, company, wandering, along_wall);
    const Vec3 open = open_way(surface, footing, wanted, kForesight, conduct.gravity);
    if (!(open == wanted)) ++measures.turned_aside;
    return open;
}

/// Turns the head as it is told; where it is to go, m/s: not over a border or onto what no foot holds on.
Vec3 obey(const Surface& surface, const Conduct& conduct, const Command& command, double careful, double dt,
          Ground& ground, CreatureMeasures& measures) noexcept {
    const double degrees = dt * std::clamp(command.turn, -conduct.turn_rate, conduct.turn_rate);
    const Vec3 left = cross(ground.footing.up, ground.facing);
    ground.facing = cos_degrees(degrees) * ground.facing + sin_degrees(degrees) * left;
    const Vec3 way = command.speed < 0 ? -1 * ground.facing : ground.facing;
    const double sight = std::abs(command.speed) * kForesight;
    if (sight == 0 || is_open(surface, ground.footing, way, sight, conduct.gravity))
        return careful * command.speed * ground.facing;
    ++measures.turned_aside;
    return {};
}

void steer(const Surface& surface, const Conduct& conduct, const Company& company, const Feel& feel,
           double reach, double dt, CreatureState& state, CreatureMeasures& measures) noexcept {
    const double careful =
        caution(feel.corner_degrees, feel.corner_distance, reach, conduct.slowest) * patience(conduct, state);
    Agent agent{state.ground.footing.position, state.ground.velocity, state.ground.footing.up,
                conduct.pace.top_speed * careful};
    Vec3 wanted;
    if (company.command) {
        wanted = obey(surface, conduct, *company.command, careful, dt, state.ground, measures);
    } else {
        if (conduct.rests) advance_pauses(conduct.pauses, company.random, dt, state.pause);
        if (!state.pause.stands || is_hunted(conduct.behaviors, agent, company))
            wanted = wish(surface, conduct, company, agent, reach, dt, state, measures);
    }
    agent.top_speed = conduct.pace.top_speed;
    state.ground.velocity = accelerate(agent, control(agent, wanted, conduct.response, conduct.strength), dt);
}

/// Moves, but not onto what no foot holds on: there it turns back as at a border.
void move_where_it_holds(const Surface& surface, const Conduct& conduct, double dt, Ground& ground,
                         CreatureMeasures& measures) noexcept {
    Ground moved = ground;
    if (move(surface, dt, moved) == MoveEnd::lost) ++measures.lost_frames;
    if (holds(surface.grip(moved.footing.at.face), moved.footing.up, conduct.gravity)) {
        ground = moved;
        return;
    }
    ground.velocity = -1 * ground.velocity;
    ++measures.turned_aside;
}

void begin_swing(const Surface& surface, const Conduct& conduct, const Limb& limb, const BodyPose& body,
                 const Pace& pace, const CreatureState& state, Foot& foot,
                 CreatureMeasures& measures) noexcept {
    const Footing& ground = state.ground.footing;
    const double swing_time =
        pace.frequency > 0 ? std::min((1 - pace.duty) / pace.frequency, kLandingTime * 2) : 0;
    const double speed = norm(state.ground.velocity);
    const Vec3 way = speed > 0 ? state.ground.velocity / speed : Vec3{};
    const Vec3 lead = (speed * swing_time + pace.duty * pace.stride / 2 * std::min(1.0, speed / 1e-3)) * way;
    const Vec3 wanted = to_world(body, stance_home(limb)) + lead;
    BodyPose landing = body;  // where it will be when the foot comes down
    landing.position += speed * swing_time * way;
    const auto serves = [&](const Foothold& hold) {
        if (!holds(surface.grip(hold.at.face), hold.up, conduct.gravity)) return false;
        if (distance(hold.position, to_world(landing, limb.base)) > kMostStretch * limb.leg.length)
            return false;
        LegPose pose = rest_pose(limb.leg);
        const LegTarget target{to_limb(limb, from_world(landing, hold.position))};
        return conduct.solver->solve(limb.leg, target, {}, pose).answer == LegAnswer::reached;
    };
    const Foothold hold = find_foothold(surface, conduct.footholds, ground, body.up, wanted, limb.leg.length,
                                        0.4 * limb.leg.length, serves);
    ++measures.steps;
    if (!hold.found) ++measures.empty_steps;
    foot.holds = hold.found;
    foot.swing.start = foot.place;
    foot.swing.start_up = body.up;
    foot.swing.end = hold.found ? hold.position : wanted + kLift * conduct.species->height * body.up;
    foot.swing.end_up = hold.found ? hold.up : body.up;
    foot.swing.height = kLift * conduct.species->height + 0.1 * distance(foot.swing.start, foot.swing.end);
}

void step_feet(const Surface& surface, const Conduct& conduct, double dt, CreatureState& state,
               CreatureMeasures& measures) noexcept {
    const std::size_t legs = conduct.species->limbs.size();
    const BodyPose body = pose_of(conduct, state);
    const Pace pace = pace_at(conduct.pace, norm(state.ground.velocity));
    std::array<std::uint8_t, kMaxLegs> strained{}, lifted{}, landed{};
    for (std::size_t leg = 0; leg < legs; ++leg)
        strained[leg] =
            !state.feet[leg].holds || strain_of(conduct.species->limbs[leg], body, pace, state.feet[leg]) > 1
                ? 1
                : 0;
    const GaitState gait = gait_state(conduct, state);
    const GaitTick tick{dt,
                        kLandingTime,
                        kTurnRate,
                        std::span(strained).first(legs),
                        std::span(lifted).first(legs),
                        std::span(landed).first(legs)};
    advance_gait(*conduct.gait, pace, tick, gait);
    for (std::size_t leg = 0; leg < legs; ++leg) {
        Foot& foot = state.feet[leg];
        if (lifted[leg] != 0)
            begin_swing(surface, conduct, conduct.species->limbs[leg], body, pace, state, foot, measures);
        if (landed[leg] != 0) foot.place = foot.swing.end;
        if (motion_of(gait, leg) == LegMotion::swings)
            foot.place = foot_at(*conduct.path, foot.swing, gait.progress[leg]);
        else
            ++measures.feet_down;
    }
}

void reach_feet(const Surface& surface, const Conduct& conduct, CreatureState& state,
                CreatureMeasures& measures) noexcept {
    const BodyPose body = pose_of(conduct, state);
    const Pace pace = pace_at(conduct.pace, norm(state.ground.velocity));
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
        const Limb& limb = conduct.species->limbs[leg];
        Foot& foot = state.feet[leg];
        const LegTarget target{to_limb(limb, from_world(body, foot.place))};
        const LegResult result = conduct.solver->solve(limb.leg, target, {}, state.poses[leg]);
        measures.worst_joint = std::max(measures.worst_joint, violation(limb.leg, state.poses[leg]));
        if (state.progress[leg] >= 0) continue;
        if (result.answer == LegAnswer::reached) {
            measures.worst_reach = std::max(measures.worst_reach, result.error / limb.leg.length);
            continue;
        }
        // Rather than be torn off, the foot lifts from where the leg still is.
        foot.place = to_world(body, to_body(limb, foot_position(limb.leg, state.poses[leg])));
        begin_swing(surface, conduct, limb, body, pace, state, foot, measures);
        state.progress[leg] = 0;
        ++measures.forced_steps;
    }
}

/// The body's middle, seen from the surface nearest to it.
struct Standoff {
    double height =
        0;      ///< m; below 0 where the surface lies between it and the ground that the creature stands on
    Vec3 away;  ///< m, from the surface to it
};

/// Whether the way between two points crosses the surface an odd number of times: past a rim it may go in and
/// out again.
bool lies_beyond(const Surface& surface, Vec3 from, const Vec3& to) noexcept {
    constexpr int kMost = 8;
    bool beyond = false;
    for (int i = 0; i < kMost; ++i) {
        const SurfaceHit hit = surface.first_hit({from, to - from, 1});
        if (hit.answer != Answer::found) break;
        beyond = !beyond;
        from += (hit.distance + 1e-6) * (to - from);
    }
    return beyond;
}

Standoff standoff_of(const Surface& surface, const Conduct& conduct, const CreatureState& state) noexcept {
    constexpr double kOff = 1e-6;  // of the height, so that a ray does not begin in the ground
    const double height = conduct.species->height;
    const Vec3 middle = pose_of(conduct, state).position;
    const SurfaceHit nearest = surface.closest_point(middle, 4 * height);
    if (nearest.answer != Answer::found) return {height, {}};
    const Footing& ground = state.ground.footing;
    const Vec3 start = ground.position + kOff * height * ground.up;
    const bool beyond = lies_beyond(surface, start, middle);
    return {beyond ? -nearest.distance : nearest.distance, middle - surface.position(nearest.at)};
}

/// Moves the body off walls and edges that its up has not turned for yet.
void keep_off(const Surface& surface, const Conduct& conduct, CreatureState& state) noexcept {
    constexpr double kLeastHeight = 0.5;  // of its height
    state.shift = {};
    const Standoff standoff = standoff_of(surface, conduct, state);
    const double length = norm(standoff.away),
                 missing = kLeastHeight * conduct.species->height - standoff.height;
    if (missing <= 0 || length == 0) return;
    state.shift = (missing / (standoff.height < 0 ? -length : length)) * standoff.away;
}

}  // namespace

BodyPose pose_of(const Conduct& conduct, const CreatureState& state) noexcept {
    BodyPose pose;
    pose.up = state.turn.up;
    const Vec3 ahead = across(state.ground.facing, pose.up);
    const double length = norm(ahead);
    // Where the head looks along the body's up, it is on its way over an edge.
    pose.forward = length > 1e-6 ? ahead / length : -1 * state.ground.footing.up;
    pose.forward = across(pose.forward, pose.up) / norm(across(pose.forward, pose.up));
    pose.right = cross(pose.forward, pose.up);
    pose.position = state.ground.footing.position + conduct.species->height * pose.up + state.shift;
    return pose;
}

Vec3 to_world(const BodyPose& pose, const Vec3& point) noexcept {
    return pose.position + point.x * pose.forward + point.y * pose.up + point.z * pose.right;
}

Vec3 from_world(const BodyPose& pose, const Vec3& point) noexcept {
    const Vec3 d = point - pose.position;
    return {dot(d, pose.forward), dot(d, pose.up), dot(d, pose.right)};
}

void place_creature(const Surface& surface, const Conduct& conduct, const Footing& footing,
                    CreatureState& state) noexcept {
    state.ground.footing = footing;
    state.ground.facing = footing.forward;
    state.turn.up = footing.up;
    begin_gait(*conduct.gait, gait_state(conduct, state));
    const BodyPose body = pose_of(conduct, state);
    CreatureMeasures unused;
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
        const Limb& limb = conduct.species->limbs[leg];
        state.poses[leg] = rest_pose(limb.leg);
        state.feet[leg].place = to_world(body, stance_home(limb));
        begin_swing(surface, conduct, limb, body, {}, state, state.feet[leg], unused);
        state.feet[leg].place = state.feet[leg].swing.end;
    }
    reach_feet(surface, conduct, state, unused);
}

void advance_creature(const Surface& surface, const Conduct& conduct, const Company& company, double dt,
                      CreatureState& state, CreatureMeasures& measures) noexcept {
    const Species& species = *conduct.species;
    const double reach = std::max(body_length(species), 0.6 * mean_leg_length(species));
    const Feel feel = feel_ahead(surface, state.ground, reach);
    steer(surface, conduct, company, feel, reach, dt, state, measures);
    move_where_it_holds(surface, conduct, dt, state.ground, measures);
    const double most = conduct.turn_rate * dt;
    if (!company.command) face_ahead(most, state.ground);
    const Vec3 before = state.turn.up;
    turn_up(feel.up, state.ground.facing, conduct.turn_curve, conduct.turn_steps, most, state.turn);
    keep_off(surface, conduct, state);
    const auto feet = state.feet;
    const auto progress = state.progress;
    step_feet(surface, conduct, dt, state, measures);
    reach_feet(surface, conduct, state, measures);
    ++measures.frames;
    for (std::size_t leg = 0; leg < species.limbs.size(); ++leg)
        if (progress[leg] < 0 && state.progress[leg] < 0)
            measures.worst_slip =
                std::max(measures.worst_slip, distance(feet[leg].place, state.feet[leg].place));
    measures.least_margin = std::min(measures.least_margin, stability_margin(conduct, state));
    measures.distance += norm(state.ground.velocity) * dt;
    measures.worst_turn = std::max(measures.worst_turn, degrees_between(before, state.turn.up));
    measures.worst_penetration = std::max(
        measures.worst_penetration, species.body.thorax.y / 2 - standoff_of(surface, conduct, state).height);
}

double stability_margin(const Conduct& conduct, const CreatureState& state) noexcept {
    const BodyPose body = pose_of(conduct, state);
    std::array<Vec3, kMaxLegs> feet;
    std::size_t count = 0;
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
        if (state.progress[leg] >= 0 || !state.feet[leg].holds) continue;
        const Vec3 place = from_world(body, state.feet[leg].place);
        feet[count++] = {place.x, 0, place.z};
    }
    if (count < 3) return -1 * conduct.species->height;
    // Over every line through two feet that has all others on one side: the hull's edges.
    double least = HUGE_VAL;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            const Vec3 edge = feet[j] - feet[i];
            const double length = norm(edge);
            if (length == 0) continue;
            const Vec3 inward{-edge.z / length, 0, edge.x / length};
            bool is_edge = true;
            for (std::size_t k = 0; k < count; ++k)
                is_edge = is_edge && dot(feet[k] - feet[i], inward) >= -1e-12;
            if (is_edge) least = std::min(least, dot(Vec3{} - feet[i], inward));
        }
    return std::isinf(least) ? -1 * conduct.species->height : least;
}

CreatureMeasures sum_of(std::span<const CreatureMeasures> all) noexcept {
    CreatureMeasures sum;
    for (const CreatureMeasures& each : all) {
        sum.frames += each.frames;
        sum.lost_frames += each.lost_frames;
        sum.turned_aside += each.turned_aside;
        sum.feet_down += each.feet_down;
        sum.steps += each.steps;
        sum.empty_steps += each.empty_steps;
        sum.forced_steps += each.forced_steps;
        sum.distance += each.distance;
        sum.worst_reach = std::max(sum.worst_reach, each.worst_reach);
        sum.worst_joint = std::max(sum.worst_joint, each.worst_joint);
        sum.worst_penetration = std::max(sum.worst_penetration, each.worst_penetration);
        sum.worst_turn = std::max(sum.worst_turn, each.worst_turn);
        sum.worst_slip = std::max(sum.worst_slip, each.worst_slip);
        sum.least_margin = std::min(sum.least_margin, each.least_margin);
    }
    return sum;
}

}  // namespace orbweaver::spider
