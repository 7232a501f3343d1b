#include "crawler_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbweaver::crawler {

namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

double number_or(const Options& options, std::string_view key, double otherwise) {
    return options.has(key) ? options.number(key) : otherwise;
}

Build read_build(const Options& options) {
    Build build;
    build.segments = static_cast<std::uint32_t>(options.integer("segments"));
    build.length = options.number("length");
    build.width = options.number("width");
    build.mass = options.number("density") * build.length * build.width * build.width;
    // As it would be without the scales, which each change one thing alone.
    const double point = build.point_mass(), unit = options.number("time_unit");
    build.stiffness = options.number("strength") * point / (unit * unit) * options.number("stiffness_scale");
    build.damping = options.number("damping") * point / unit * options.number("damping_scale");
    build.mass *= options.number("mass_scale");
    build.keeps_volume = options.flag("constant_volume");
    return build;
}

Friction read_friction(const Options& options, const Vec3& gravity) {
    Friction friction;
    friction.law = options.text("friction.law") == "one_way" ? FrictionLaw::one_way : FrictionLaw::coulomb;
    friction.forward = options.number("friction.forward");
    friction.backward = options.number("friction.backward");
    friction.sideways = options.number("friction.sideways");
    // Half of the points are at the bottom, and carry all.
    friction.adhesion = 2 * options.number("adhesion") * norm(gravity);
    return friction;
}

std::optional<Path> read_path(const Options& options, double length) {
    if (!options.has("follow_path.points") || options.vectors("follow_path.points").empty())
        return std::nullopt;
    return Path{options.vectors("follow_path.points"), options.flag("follow_path.loop"),
                number_or(options, "follow_path.ahead", length / 2)};
}

std::vector<TimedCommand> read_script(const Options& options) {
    std::vector<TimedCommand> script;
    for (const std::string& name : options.names_in("control")) {
        const std::string key = "control." + name;
        const double begin = number_or(options, key + ".at", 0);
        script.push_back({begin,
                          begin + number_or(options, key + ".for", kForever),
                          {number_or(options, key + ".pace", 1), number_or(options, key + ".turn", 0)}});
    }
    std::stable_sort(script.begin(), script.end(),
                     [](const auto& a, const auto& b) { return a.begin < b.begin; });
    return script;
}

void read_settings(const Options& options, Crawler& into) {
    using namespace mass_spring;
    into.settings.method = find_method(options.text("method"));
    into.settings.step = number_or(options, "step", 0);
    into.settings.max_substeps = options.integer("max_substeps");
    into.settings.on_unstable = on_unstable_named(options.text("on_unstable"));
    into.linear_solver = linear_solver_named(options.text("linear_solver"));
}

bool is_steered(const Options& options, const Crawler& crawler) {
    return crawler.seek || crawler.path || options.flag("keys") ||
           std::any_of(crawler.script.begin(), crawler.script.end(),
                       [](const TimedCommand& each) { return each.command.turn != 0; });
}

/// 1/m, sharpest of all that a gait bends them to, steering apart.
double sharpest_bend(const Crawler& crawler) {
    const double side = crawler.gait->bends ? crawler.effort.bend : 0,
                 up = crawler.gait->lifts ? crawler.effort.lift : 0;
    const bool apart = crawler.form == WaveForm::sine && crawler.gait->lift_later != 0;  // a quarter of a wave
    return apart ? std::hypot(side, up) : side + up;
}

/// Muscles may not ask a bend's inside for less than no length, where bends are sharpest and segments shortest.
void check_shapes(const Options& options, const Crawler& crawler, Diagnostics& faults) {
    const double length = crawler.build.length, strain = crawler.gait->strains ? crawler.effort.strain : 0;
    const double width = crawler.build.width / (crawler.build.keeps_volume ? std::sqrt(1 - strain) : 1);
    const double turn = is_steered(options, crawler) ? crawler.effort.turn : 0;
    const double most = 2 * (1 - strain) / width;
    if (sharpest_bend(crawler) + turn < most) return;
    const char* key = turn > 0 ? "turn" : "width";
    if (crawler.gait->lifts) key = "lift";
    if (crawler.gait->bends) key = "bend";
    faults.push_back(
        {options.where(key), "muscles would fold over what is inside of bends",
         fmt::format("bends and turns of less than {:.3g} together, as curvatures over one length{}",
                     most * length,
                     strain > 0 ? fmt::format(", where segments shorten by {:.3g}", strain) : ""),
         "ask for less of them, or a thinner body"});
}

/// Two goals at once, and waves that the segments do not resolve.
void check(const Options& options, const Crawler& crawler, Diagnostics& faults) {
    constexpr double kFewest = 4;  // segments a wave
    if (crawler.seek && crawler.path)
        faults.push_back({options.where("seek.point"), "they are to go to a point and along a path at once",
                          "either 'seek' or 'follow_path'", "leave one out"});
    if (crawler.waves * kFewest > crawler.build.segments)
        faults.push_back({options.where("waves"), fmt::format("waves are shorter than {} segments", kFewest),
                          fmt::format("at most {} of them in {} segments", crawler.build.segments / kFewest,
                                      crawler.build.segments),
                          "ask for fewer waves, or more segments"});
    for (const char* key : {"cliff.drop", "cliff.radius"})
        if (options.given(key) && !options.has("cliff.edge")) {
            faults.push_back({options.where(key), "a cliff has no edge", "'cliff.edge', an x in m", ""});
            break;
        }
}

Pose pose_along(const Vec3& middle, const Vec3& heading, const Vec3& up) {
    Vec3 forward = across(heading, up);
    if (!(norm(forward) > 1e-9)) forward = across(std::abs(up.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 0, 1}, up);
    return {middle, forward / norm(forward), up};
}

class Placer {
public:
    Placer(const Options& options, const Crawler& crawler, const Surface* surface)
        : options_(options),
          crawler_(crawler),
          surface_(surface),
          above_(options.number("height") + crawler.build.width / 2) {}

    std::vector<Vec3> place(Diagnostics& faults) {
        std::vector<Vec3> points;
        const double spacing = number_or(options_, "spacing", 4 * crawler_.build.width);
        const Pose first = pose_along(options_.vector("position"), options_.vector("heading"), {0, 1, 0});
        for (std::uint32_t i = 0; i < crawler_.count; ++i) {
            const Pose at{first.middle + i * spacing * first.right(), first.forward, first.up};
            if (surface_ == nullptr) {
                lie_on_floor(at, points);
            } else if (!lie_on_surface(at, points)) {
                faults.push_back({options_.where("position"), "there is no surface near it",
                                  "a point at a finite distance from the surface", ""});
                break;
            }
        }
        return points;
    }

private:
    void add(Pose ring, std::vector<Vec3>& points) const {
        ring.middle += above_ * ring.up;
        if (options_.flag("upside_down")) ring.up = -ring.up;
        add_ring_points(ring, crawler_.build.width, points);
    }

    void lie_on_floor(Pose at, std::vector<Vec3>& points) const {
        at.middle.y = options_.number("floor");
        const double reach = crawler_.build.length / 2 * std::abs(at.forward.x) + crawler_.build.width;
        if (options_.has("cliff.edge") && at.middle.x - reach > options_.number("cliff.edge"))
            at.middle.y -= options_.number("cliff.drop");
        for (std::uint32_t ring = 0; ring <= crawler_.build.segments; ++ring)
            add({at.middle + (crawler_.build.segment() * ring - crawler_.build.length / 2) * at.forward,
                 at.forward, at.up},
                points);
    }

    bool lie_on_surface(const Pose& at, std::vector<Vec3>& points) const {
        const SurfaceHit hit = surface_->closest_point(at.middle, kForever);
        if (hit.answer != Answer::found) return false;
        const Vec3 normal = surface_->normal(hit.at.face);
        const SurfaceStep start = surface_->place(hit.at, normal, options_.vector("heading"));
        if (start.answer != Answer::found) return false;
        const std::uint32_t half = crawler_.build.segments / 2;
        Footing back = start.end;
        back.forward = -back.forward;
        std::vector<Pose> rings = walk(back, half);
        std::reverse(rings.begin(), rings.end());
        for (Pose& ring : rings) ring.forward = -ring.forward;
        const std::vector<Pose> ahead = walk(start.end, crawler_.build.segments - half);
        rings.push_back({start.end.position, start.end.forward, start.end.up});
        rings.insert(rings.end(), ahead.begin(), ahead.end());
        for (const Pose& ring : rings) add(ring, points);
        return true;
    }

    std::vector<Pose> walk(Footing from, std::uint32_t count) const {
        std::vector<Pose> rings;
        bool ended = false;
        for (std::uint32_t i = 0; i < count; ++i) {
            const double length = crawler_.build.segment();
            const SurfaceStep step = ended ? SurfaceStep{} : surface_->step(from, length);
            ended = ended || step.answer != Answer::found || step.stop != StepStop::none;
            if (ended)
                from.position += length * from.forward;
            else
                from = step.end;
            rings.push_back({from.position, from.forward, from.up});
        }
        return rings;
    }

    const Options& options_;
    const Crawler& crawler_;
    const Surface* surface_;
    double above_;  // m, of middles
};

}  // namespace

Crawler read_crawler(const Options& options, const Vec3& gravity, Diagnostics& faults) {
    Crawler crawler;
    crawler.count = static_cast<std::uint32_t>(options.integer("count"));
    crawler.build = read_build(options);
    crawler.gait = find_gait(options.text("gait"));
    crawler.form = options.text("wave") == "square" ? WaveForm::square : WaveForm::sine;
    crawler.waves = options.number("waves");
    crawler.period = options.number("period");
    const double length = crawler.build.length;
    crawler.effort = {options.number("strain"), options.number("bend") / length,
                      options.number("lift") / length, options.number("turn") / length};
    crawler.friction = read_friction(options, gravity);
    crawler.drag = options.number("drag");
    if (options.has("seek.point")) crawler.seek = options.vector("seek.point");
    crawler.path = read_path(options, length);
    crawler.script = read_script(options);
    read_settings(options, crawler);
    check(options, crawler, faults);
    check_shapes(options, crawler, faults);
    return crawler;
}

Ground read_ground(const Options& options, const Crawler& crawler, const Surface* surface, Workers* workers,
                   Diagnostics& faults) {
    for (const char* key : {"floor", "cliff.edge"})
        if (surface != nullptr && options.given(key))
            faults.push_back({options.where(key), "there are two grounds to crawl on",
                              "either a surface, or a floor of the crawler's own", "leave one out"});
    if (surface != nullptr) {
        const std::size_t points = std::size_t{crawler.count} * kCorners * (crawler.build.segments + 1);
        return SurfaceGround(*surface, points, crawler.build.width, workers);
    }
    const double height = options.number("floor");
    if (!options.has("cliff.edge")) return Floor{height};
    const Cliff cliff{height, options.number("cliff.edge"), options.number("cliff.radius"),
                      options.number("cliff.drop")};
    if (2 * cliff.radius > cliff.drop)
        faults.push_back({options.where("cliff.radius"), "the rounded edge is higher than half of the cliff",
                          "a radius of at most half of 'cliff.drop'", "make one smaller, or the other larger"});
    return cliff;
}

std::vector<Vec3> read_places(const Options& options, const Crawler& crawler, const Surface* surface,
                              Diagnostics& faults) {
    return Placer(options, crawler, surface).place(faults);
}

}  // namespace orbweaver::crawler
