#include "conduct_options.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

namespace orbweaver::spider {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

double number_or(const Options& options, std::string_view key, double otherwise) {
    return options.has(key) ? options.number(key) : otherwise;
}

PaceRange pace_of(const Options& options, const Walk& walk) {
    PaceRange pace{number_or(options, "speed", walk.speed), walk.stride[0], walk.stride[1], walk.duty[0],
                   walk.duty[1]};
    if (options.has("duty")) pace.slow_duty = pace.fast_duty = options.number("duty");
    return pace;
}

TurnCurve turn_curve_of(std::string_view name) {
    return name == "cosine"             ? TurnCurve::cosine
           : name == "slow_in_slow_out" ? TurnCurve::slow_in_slow_out
                                        : TurnCurve::linear;
}

/// The behaviors of one table of a scene; a path is laid along the surface.
class BehaviorReader {
public:
    BehaviorReader(Host& host, const Surface& surface, const Species& species)
        : host_(host), options_(host.options()), surface_(surface), leg_(mean_leg_length(species)) {}

    Behaviors read() {
        Behaviors all;
        all.seek = goal("seek");
        all.flee = goal("flee");
        all.flee_within = number_or(options_, "flee.within", kForever);
        all.arrive = goal("arrive");
        all.slowing = number_or(options_, "arrive.slowing", leg_);
        all.pursue = weight("pursue", "target");
        all.evade = weight("evade", "target");
        all.evade_within = number_or(options_, "evade.within", kForever);
        read_path(all);
        read_obstacles(all);
        all.keep_apart = options_.number("keep_apart.weight");
        all.apart = number_or(options_, "keep_apart.reach", 1.5 * leg_);
        all.follow_wall = weight("follow_wall", "climb");
        all.walls.distance = number_or(options_, "follow_wall.distance", leg_);
        all.walls.climb = number_or(options_, "follow_wall.climb", 0);
        all.walls.time = options_.number("follow_wall.time");
        // Who has somewhere to go wanders only when that is asked for, too.
        const bool goes = all.seek.weight > 0 || all.arrive.weight > 0 || all.pursue > 0 || all.follow_path > 0;
        const bool asked = options_.given("wander.displacement") || options_.given("wander.rate");
        all.wander = number_or(options_, "wander.weight", goes && !asked ? 0 : 1);
        return all;
    }

private:
    /// Of a behavior that is there when the scene gives what it is about.
    double weight(const std::string& name, const std::string& about) {
        const std::string group = name + ".", needed = group + about;
        if (options_.has(needed)) return options_.number(group + "weight");
        for (const auto& [key, entry] : options_.entries())
            if (key.starts_with(group) && options_.given(key)) {
                host_.report_fault({entry.where, "'" + needed + "' is missing",
                                    "what '" + key + "' is to count for",
                                    "add it, or leave '" + key + "' out"});
                break;
            }
        return 0;
    }

    std::optional<SurfacePoint> on_surface(const Vec3& point, const std::string& key) {
        const SurfaceHit hit = surface_.closest_point(point, kForever);
        if (hit.answer == Answer::found) return hit.at;
        host_.report_fault({options_.where(key), "'" + key + "' finds no place on the surface", "", ""});
        return std::nullopt;
    }

    Behaviors::Goal goal(const std::string& name) {
        const double counts = weight(name, "point");
        if (counts == 0) return {};
        const auto point = on_surface(options_.vector(name + ".point"), name + ".point");
        return point ? Behaviors::Goal{WayField(surface_, *point), counts} : Behaviors::Goal{};
    }

    void read_path(Behaviors& all) {
        all.follow_path = weight("follow_path", "points");
        if (all.follow_path == 0) return;
        all.path_ahead = number_or(options_, "follow_path.ahead", leg_);
        const bool loop = options_.flag("follow_path.loop");
        std::vector<SurfacePoint> corners;
        for (const Vec3& point : options_.vectors("follow_path.points"))
            if (const auto corner = on_surface(point, "follow_path.points")) corners.push_back(*corner);
        if (corners.empty())
            host_.report_fault({options_.where("follow_path.points"), "'follow_path.points' is empty",
                                "at least one point", ""});
        else
            lay_path(corners, loop, all);
    }

    void lay_path(std::vector<SurfacePoint> corners, bool loop, Behaviors& all) {
        if (loop) corners.push_back(corners.front());
        all.loop = loop;
        all.path = {surface_.position(corners.front())};
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            const auto way = shortest_way(surface_, corners[i], corners[i + 1], all.path_ahead / 4);
            all.path.insert(all.path.end(), way.begin() + 1, way.end());
        }
        if (loop && all.path.size() > 1) all.path.pop_back();
    }

    void read_obstacles(Behaviors& all) {
        all.avoid_obstacles = weight("avoid_obstacles", "centers");
        if (all.avoid_obstacles == 0) return;
        const std::vector<Vec3>& centers = options_.vectors("avoid_obstacles.centers");
        const std::vector<double> radii = options_.has("avoid_obstacles.radii")
                                              ? options_.numbers("avoid_obstacles.radii")
                                              : std::vector<double>{};
        if (radii.size() != centers.size()) {
            host_.report_fault(
                {options_.where("avoid_obstacles.radii"),
                 std::to_string(centers.size()) + " obstacles have " + std::to_string(radii.size()) + " radii",
                 "as many radii as centers", ""});
            return;
        }
        for (std::size_t i = 0; i < radii.size(); ++i) all.obstacles.push_back({centers[i], radii[i] + leg_});
    }

    Host& host_;
    const Options& options_;
    const Surface& surface_;
    double leg_;  // m, the mean length
};

}  // namespace

Conduct conduct_of(Host& host, const Surface& surface, const Species& species) {
    const Options& options = host.options();
    Conduct conduct;
    conduct.species = &species;
    conduct.gait = find_gait(options.has("gait") ? options.text("gait") : species.walk.gait);
    if (options.has("path")) conduct.path = find_stride_path(options.text("path"));
    conduct.jitter = options.number("jitter");
    conduct.solver = find_leg_solver(options.text("ik"));
    conduct.footholds = options.text("footholds") == "rays" ? FootholdWay::rays : FootholdWay::surface;
    conduct.pace = pace_of(options, species.walk);
    conduct.behaviors = BehaviorReader(host, surface, species).read();
    conduct.wander.displacement = options.number("wander.displacement");
    conduct.wander.rate = options.number("wander.rate");
    conduct.wander.on_ball = options.text("wander.form") == "ball";
    conduct.rests = options.flag("rests");
    conduct.motion = find_motion_method(options.text("motion"));
    conduct.turn_rate = options.number("turn_rate");
    conduct.turn_curve = turn_curve_of(options.text("turn_curve"));
    conduct.turn_steps = static_cast<std::uint32_t>(options.integer("turn_steps"));
    conduct.orient_every = static_cast<std::uint32_t>(options.integer("orient_every"));
    conduct.gravity = host.scene().gravity;
    return conduct;
}

std::vector<TimedCommand> control_of(const Options& options) {
    std::vector<TimedCommand> script;
    for (const std::string& name : options.names_in("control")) {
        const std::string key = "control." + name;
        const double begin = number_or(options, key + ".at", 0);
        const double end = begin + number_or(options, key + ".for", kForever);
        script.push_back(
            {begin, end, {number_or(options, key + ".speed", 0), number_or(options, key + ".turn", 0)}});
    }
    std::stable_sort(script.begin(), script.end(),
                     [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return script;
}

}  // namespace orbweaver::spider
