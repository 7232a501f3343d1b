#include "creature.hpp"

#include <algorithm>
#include <cmath>

#include "backbone.hpp"
#include "keep_off.hpp"
#include "open_way.hpp"
#include "orbweaver/exact_math.hpp"
#include "rotor.hpp"
#include "stepping.hpp"
#include "unit.hpp"

namespace orbweaver::spider {
namespace {

constexpr double kForesight = 0.35;  // s, in which it sees borders coming and what no foot holds on
constexpr double kCreep = 0.1;       // of its top speed

double body_length(const Species& species) noexcept {
    return species.body.head.x + species.body.thorax.x + species.body.abdomen.x;
}

/// The part of its speed that a creature keeps which waits for its legs.
double patience(const CreatureState& state) noexcept {
    constexpr double kSlowest = 0.2, kEasy = 1.2;
    return std::clamp(1 - 3 * (state.strain - kEasy), kSlowest, 1.0);
}

/// The part of its speed that a creature keeps whose body has not turned yet as the ground wants it to.
double alignment(const CreatureState& state, const Vec3& wanted_up) noexcept {
    constexpr double kSlowest = 0.15, kNear = 15, kFar = 60;  // degrees
    const double off = degrees_between(state.turn.up, wanted_up);
    return std::clamp(1 - (off - kNear) / (kFar - kNear), kSlowest, 1.0);
}

/// Who wanders to where the surface ends is turned aside, to the side that has more room: the nearer the
/// end, the slower.
Vec3 clear_of_borders(const Ground& ground, const Feel& feel, double reach, const Vec3& wanted) noexcept {
    constexpr double kSlowest = 0.05, kApart = 0.3;  // of the speed; of the reach, which is kept from it
    if (feel.border_distance >= reach) return wanted;
    const Vec3 left = cross(ground.footing.up, ground.facing);
    return norm(wanted) * std::max(kSlowest, feel.border_distance / reach - kApart) *
           (feel.room_left >= feel.room_right ? left : -1 * left);
}

/// One frame of a creature, and what it feels at its beginning.
struct Moment {
    const Surface& surface;
    const Conduct& conduct;
    const Company& company;
    double dt;  ///< s
    CreatureState& state;
    CreatureMeasures& measures;
    double reach;  ///< m, of what it feels
    Feel feel;
};

Vec3 wish(const Moment& now, const Agent& agent) noexcept {
    const Behaviors& wants = now.conduct.behaviors;
    const Ground& ground = now.state.ground;
    const Vec3 ahead = unit_or(ground.velocity, ground.facing);
    Vec3 wandering, along_wall;
    if (wants.wander > 0)
        wandering = clear_of_borders(
            ground, now.feel, now.reach,
            wander(agent, ahead, now.conduct.wander, now.company.random, now.dt, now.state.wander));
    if (wants.follow_wall > 0)
        along_wall = follow_wall(now.surface, ground, agent, now.reach, wants.walls, now.company.random, now.dt,
                                 now.state.wall);
    const Vec3 wanted = combined(wants, agent, ground.footing.at, now.company, wandering, along_wall);
    const Vec3 open = open_way(now.surface, ground.footing, wanted, kForesight, now.conduct.gravity);
    if (!(open == wanted)) ++now.measures.turned_aside;
    return open;
}

/// A wish is bent away from where feet find nothing to stand on, or no more than a rim.
Vec3 away_from_gaps(const Conduct& conduct, const CreatureState& state, const Vec3& wanted) noexcept {
    const Footing& ground = state.ground.footing;
    Vec3 away;
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) {
        if (state.feet[leg].holds && !state.feet[leg].rim) continue;
        const Vec3 off = across(ground.position - state.feet[leg].place, ground.up);
        const double length = norm(off);
        if (length > 0) away += off / length;
    }
    const Vec3 bent = wanted + norm(wanted) * away;
    const double length = norm(bent);
    return away == Vec3{} || length == 0 ? wanted : (norm(wanted) / length) * bent;
}

/// A creature goes where its head looks, or little aside of it: what it wishes to go farther about waits for
/// the head to turn, the slower the farther. Whoever is as slow as `creep` (m/s) may go aside.
Vec3 ahead_of_head(const Ground& ground, double creep, const Vec3& wanted) noexcept {
    constexpr double kAside = 25, kSlowest = 0.3;  // degrees; of the speed
    const double speed = norm(wanted);
    if (speed <= creep) return wanted;
    const Vec3 way = turned_about(ground.footing.up, ground.facing, wanted / speed, kAside);
    return std::max(creep, std::max(kSlowest, dot(way, wanted) / speed) * speed) * way;
}

/// Turns the head as it is told; where it is to go, m/s: not over a border or onto what no foot holds on.
Vec3 obey(const Moment& now, const Command& command, double careful) noexcept {
    Ground& ground = now.state.ground;
    const double degrees = now.dt * std::clamp(command.turn, -now.conduct.turn_rate, now.conduct.turn_rate);
    const Vec3 left = cross(ground.footing.up, ground.facing);
    ground.facing = cos_degrees(degrees) * ground.facing + sin_degrees(degrees) * left;
    const Vec3 way = command.speed < 0 ? -1 * ground.facing : ground.facing;
    const double sight = std::min(std::abs(command.speed), now.conduct.pace.top_speed) * kForesight;
    if (sight == 0 || is_open(now.surface, ground.footing, way, sight, now.conduct.gravity))
        return careful * command.speed * ground.facing;
    ++now.measures.turned_aside;
    return {};
}

/// Gives it another velocity; m/s, by which it is to move.
Vec3 steer(const Moment& now) noexcept {
    const Conduct& conduct = now.conduct;
    CreatureState& state = now.state;
    const double careful =
        std::min({caution(now.feel.corner_degrees, now.feel.corner_distance, now.reach, conduct.slowest),
                  alignment(state, now.feel.up), patience(state)});
    Agent agent{state.ground.footing.position, state.ground.velocity, state.ground.footing.up,
                conduct.pace.top_speed * careful};
    Vec3 wanted;
    if (now.company.command) {
        wanted = obey(now, *now.company.command, careful);
    } else {
        if (conduct.rests) advance_pauses(conduct.pauses, now.company.random, now.dt, state.pause);
        if (!state.pause.stands || is_hunted(conduct.behaviors, agent, now.company))
            wanted = away_from_gaps(conduct, state, wish(now, agent));
        wanted = ahead_of_head(state.ground, kCreep * conduct.pace.top_speed, wanted);
    }
    agent.top_speed = conduct.pace.top_speed;
    const Motion motion = moved(conduct.motion, agent, wanted, conduct.response, conduct.strength, now.dt);
    state.ground.velocity = motion.velocity;
    return motion.way;
}

/// Moves, but not onto what no foot holds on: there it turns back as at a border.
void move_where_it_holds(const Moment& now, const Vec3& way) noexcept {
    Ground& ground = now.state.ground;
    Ground moved = ground;
    const MoveEnd end = move(now.surface, now.dt, 1.3 * now.conduct.species->carriage, way, moved);
    if (end == MoveEnd::lost) ++now.measures.lost_frames;
    if (holds(now.surface.grip(moved.footing.at.face), moved.footing.up, now.conduct.gravity)) {
        ground = moved;
        return;
    }
    ground.velocity = -1 * ground.velocity;
    ++now.measures.turned_aside;
}

/// Up and forward in dt s, both together by no more than the creature's rate: they turn about axes at right
/// angles.
void turn_body(const Conduct& conduct, const Vec3& wanted_up, double dt, CreatureState& state) noexcept {
    constexpr double kUpsShare = 0.8;  // of the rate; it leaves forward three fifths
    const double most_degrees = conduct.turn_rate * dt;
    const Vec3 before = state.turn.up;
    turn_up(wanted_up, state.forward, conduct.turn_curve, conduct.turn_steps, kUpsShare * most_degrees,
            state.turn);
    const Vec3& up = state.turn.up;
    state.forward = carried_over(state.forward, before, up);
    const Vec3 ahead = across(state.ground.facing, up);
    const double length = norm(ahead), turned = degrees_between(before, up);
    constexpr double kLeast = 1e-6;  // where the head looks along the body's up, it is on its way over an edge
    state.spin = 0;
    if (length < kLeast) return;
    const Vec3 carried = state.forward;
    const double left = std::sqrt(std::max(0.0, most_degrees * most_degrees - turned * turned));
    state.forward = turned_about(up, carried, ahead / length, left);
    state.spin = dot(cross(carried, state.forward), up) / dt;  // the sine of so little is the angle
}

/// What a frame changes of where a body is, before its feet step.
struct BodyPlace {
    Ground ground;
    UpTurn turn;
    Vec3 forward, shift;
    double spin, bend;

    explicit BodyPlace(const CreatureState& state) noexcept
        : ground(state.ground),
          turn(state.turn),
          forward(state.forward),
          shift(state.shift),
          spin(state.spin),
          bend(state.bend) {}
    void put_back(CreatureState& state) const noexcept {
        state.ground = ground;
        state.turn = turn;
        state.forward = forward;
        state.shift = shift;
        state.spin = spin;
        state.bend = bend;
    }
};

/// Moves the body off what it would come too near to, and back to its height in a moment where there is
/// nothing; m, by which it is still below the surface.
double hold_body(const Surface& surface, const Conduct& conduct, double dt, CreatureState& state) noexcept {
    constexpr double kOfLegs = 0.8, kMoment = 0.15;  // s
    const Species& species = *conduct.species;
    const double most = std::max(kOfLegs * mean_leg_length(species), body_length(species));
    double below = 0;
    // Where it finds no way out from where it is, it may from its place.
    for (const Vec3& from : {std::max(0.0, 1 - dt / kMoment) * state.shift + state.sway, state.sway}) {
        state.shift = from;
        BodyPose unshifted = pose_of(conduct, state);
        unshifted.position -= from;
        below = keep_off(surface, species.shape, state.ground.footing, unshifted, most, state.shift);
        if (below == 0) break;
    }
    return below;
}

/// The body where there is room for it. Who came to where there is none goes back, and turns where it was, or
/// goes on and does not turn; who can do neither stays as it was. Who had no room before goes on.
void find_room(const Moment& now, const BodyPlace& before) noexcept {
    CreatureState& state = now.state;
    const auto fits = [&] { return hold_body(now.surface, now.conduct, now.dt, state) == 0; };
    const double depth_before = state.depth;
    state.depth = hold_body(now.surface, now.conduct, now.dt, state);
    if (state.depth == 0 || depth_before > 0) return;
    state.depth = 0;
    ++now.measures.turned_aside;
    const Ground moved = state.ground;
    state.ground = before.ground;
    state.shift = before.shift;
    if (!fits()) {
        before.put_back(state);
        state.ground = moved;
        if (fits()) return;
        before.put_back(state);
    }
    state.ground.velocity = -1 * state.ground.velocity;
}

/// m, in dt s: who is out of balance, or nearly so, leans towards where it is in balance.
Vec3 sway_of(const Conduct& conduct, const Support& support, const CreatureState& state, double dt) noexcept {
    constexpr double kWanted = 0.03, kSpeed = 0.7;  // margin, of the legs' length; of it a second
    const double leg = mean_leg_length(*conduct.species);
    const double missing = std::min(kWanted * leg - support.margin, kSpeed * leg * dt);
    if (missing <= 0) return {};
    const BodyPose body = pose_of(conduct, state);
    return missing * (support.inward.forward * body.forward + support.inward.right * body.right);
}

/// Degrees of the one turn that leads from pose to pose: the chords of its axes, squared, sum to 8 sin^2(a/2).
double degrees_turned(const BodyPose& from, const BodyPose& to) noexcept {
    const auto square = [](const Vec3& v) { return dot(v, v); };
    const double sine = std::sqrt(
        (square(to.forward - from.forward) + square(to.up - from.up) + square(to.right - from.right)) / 8);
    return 2 / kDegree * angle_of(std::sqrt(std::max(0.0, 1 - sine * sine)), sine);
}

/// What a frame is compared with that comes after it.
struct Before {
    BodyPose pose;
    Vec3 place;  ///< m, of the ground under it
    std::array<double, kMaxLegs> progress;
    std::array<Vec3, kMaxLegs> feet;

    Before(const Conduct& conduct, const CreatureState& state) noexcept
        : pose(pose_of(conduct, state)), place(state.ground.footing.position), progress(state.progress) {
        for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg) feet[leg] = state.feet[leg].place;
    }
    /// m, the farthest that a foot slipped which stood then and stands now.
    double slip(const CreatureState& now, std::size_t legs) const noexcept {
        double worst = 0;
        for (std::size_t leg = 0; leg < legs; ++leg)
            if (progress[leg] < 0 && now.progress[leg] < 0)
                worst = std::max(worst, distance(feet[leg], now.feet[leg].place));
        return worst;
    }
};

}  // namespace

BodyPose pose_of(const Conduct& conduct, const CreatureState& state) noexcept {
    const Vec3& up = state.turn.up;
    return {state.ground.footing.position + conduct.species->carriage * up + state.shift, state.forward, up,
            cross(state.forward, up), state.bend};
}

const char* not_finite(const Conduct& conduct, const CreatureState& state) noexcept {
    const BodyPose pose = pose_of(conduct, state);
    if (!is_finite(pose.position)) return "position";
    if (!is_finite(pose.forward)) return "forward";
    if (!is_finite(pose.up)) return "up";
    for (std::size_t leg = 0; leg < conduct.species->limbs.size(); ++leg)
        if (!is_finite(state.feet[leg].place)) return "a foot";
    return nullptr;
}

bool stands_on(const Surface& surface, const CreatureState& state) noexcept {
    constexpr double kRounding = 1e-9;  // of the surface's size
    const Footing& footing = state.ground.footing;
    return footing.at.face < surface.faces().size() &&
           distance(surface.position(footing.at), footing.position) <= kRounding * surface.size();
}

void place_creature(const Surface& surface, const Conduct& conduct, const Footing& footing,
                    CreatureState& state) noexcept {
    state.ground.footing = footing;
    state.ground.facing = state.forward = footing.forward;
    state.turn.up = state.turn.to = footing.up;
    state.depth = hold_body(surface, conduct, 0, state);
    place_feet(surface, conduct, state);
}

double feel_reach(const Species& species) noexcept {
    return std::max(body_length(species), 0.6 * mean_leg_length(species));
}

Feel feel_ground(const Surface& surface, const Species& species, const Ground& ground) noexcept {
    return feel_ahead(surface, ground, feel_reach(species), 1.5 * species.carriage);
}

void advance_creature(const Surface& surface, const Conduct& conduct, const Company& company, double dt,
                      CreatureState& state, CreatureMeasures& measures) noexcept {
    const Species& species = *conduct.species;
    const Before before(conduct, state);
    const Moment now{surface,
                     conduct,
                     company,
                     dt,
                     state,
                     measures,
                     feel_reach(species),
                     feel_ground(surface, species, state.ground)};
    const BodyPlace place(state);
    move_where_it_holds(now, steer(now));
    if (!company.command) face_ahead(conduct.turn_rate * dt, state.ground);
    turn_body(conduct, company.orients ? now.feel.up : state.turn.to, dt, state);
    bend_back(conduct, dt, state);
    find_room(now, place);
    step_feet(surface, conduct, company.random, dt, state, measures);
    ++measures.frames;
    const Support support = support_of(conduct, state);
    state.sway = sway_of(conduct, support, state, dt);
    const double margin = std::max(support.margin, -species.height);
    if (margin < 0) ++measures.unstable_frames;
    if (state.depth > 0) ++measures.penetrating_frames;
    measures.margins += margin;
    measures.least_margin = std::min(measures.least_margin, margin);
    measures.distance += distance(before.place, state.ground.footing.position);
    measures.worst_penetration = std::max(measures.worst_penetration, state.depth);
    measures.worst_slip = std::max(measures.worst_slip, before.slip(state, species.limbs.size()));
    measures.worst_turn = std::max(measures.worst_turn, degrees_turned(before.pose, pose_of(conduct, state)));
}

Support support_of(const Conduct& conduct, const CreatureState& state) noexcept {
    const Species& species = *conduct.species;
    const BodyPose body = pose_of(conduct, state);
    std::array<SupportPoint, kMaxLegs> feet;
    std::size_t count = 0;
    for (std::size_t leg = 0; leg < species.limbs.size(); ++leg) {
        if (state.progress[leg] >= 0) continue;
        const Vec3 place = from_world(body, state.feet[leg].place) - species.shape.center_of_mass;
        feet[count++] = {place.x, place.z};
    }
    return support_of(std::span(feet).first(count));
}

}  // namespace orbweaver::spider
