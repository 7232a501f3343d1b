#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "creature.hpp"
#include "creature_numbers.hpp"
#include "leg_ways.hpp"
#include "manifest_text.hpp"
#include "neighbors.hpp"
#include "orbweaver/contracts/skins.hpp"
#include "orbweaver/contracts/workers.hpp"
#include "orbweaver/entry.hpp"
#include "sketch.hpp"
#include "skin.hpp"

namespace orbweaver::spider {
namespace {

PaceRange pace_of(const Options& options, const Walk& walk) {
    PaceRange pace{options.has("speed") ? options.number("speed") : walk.speed, walk.stride[0], walk.stride[1],
                   walk.duty[0], walk.duty[1]};
    if (options.has("duty")) pace.slow_duty = pace.fast_duty = options.number("duty");
    return pace;
}

Conduct conduct_of(const Host& host, const Species& species) {
    const Options& options = host.options();
    Conduct conduct;
    conduct.species = &species;
    conduct.gait = find_gait(options.has("gait") ? options.text("gait") : species.walk.gait);
    conduct.path = find_stride_path(options.text("path"));
    conduct.solver = find_leg_solver(options.text("ik"));
    conduct.footholds = options.text("footholds") == "rays" ? FootholdWay::rays : FootholdWay::surface;
    conduct.pace = pace_of(options, species.walk);
    conduct.wander.displacement = options.number("wander.displacement");
    conduct.wander.rate = options.number("wander.rate");
    conduct.rests = options.flag("rests");
    conduct.turn_rate = options.number("turn_rate");
    conduct.gravity = host.scene().gravity;
    return conduct;
}

std::vector<Leg> legs_of(const Species& species) {
    std::vector<Leg> legs;
    for (const Limb& limb : species.limbs) legs.push_back(limb.leg);
    return legs;
}

/// One [spider] table: creatures of one kind.
class SpiderModule final : public Module, public Skins, public Sketch {
public:
    void attach(Host& host) override {
        Diagnostics faults;
        auto species = read_species_file(host.options().text("species"), faults);
        for (Diagnostic& fault : faults) host.report_fault(std::move(fault));
        if (!species) return;
        species_ = std::move(*species);
        surface_ = host.find<Surface>();
        workers_ = host.find<Workers>();
        conduct_ = conduct_of(host, species_);
        if (host.options().text("ik") == "half_jacobian") conduct_.lanes = &lanes_.emplace(legs_of(species_));
        debug_ = host.options().flag("debug");
        const auto count = static_cast<std::size_t>(host.options().integer("count"));
        creatures_.resize(count);
        measures_.resize(count);
        make_state(host, count);
        if (!place(host)) return;
        keep_state();
        ways_.emplace(species_);
        host.provide<ReachWays>(*ways_);
        host.provide<Skins>(*this);
        host.provide<Sketch>(*this);
    }

    void run(Phase, const orbweaver::Frame& frame) override {
        step_ = frame.step;
        const double reach = 1.5 * mean_leg_length(species_);
        if (creatures_.size() > 1) neighbors_.gather(position_, reach);
        for_each([&](std::size_t i) { advance_one(i, reach, frame.step); });
        keep_state();
    }

    void restored() override {
        for (std::size_t i = 0; i < creatures_.size(); ++i)
            read_numbers(&numbers_[i * per_creature_], species_.limbs.size(), creatures_[i]);
    }

    void report(ModuleReport& report) override {
        report.memory_bytes = creatures_.capacity() * (sizeof(CreatureState) + sizeof(CreatureMeasures)) +
                              neighbors_.memory_bytes() + moves_.capacity() * sizeof(SkinMove) +
                              lines_.capacity() * sizeof(SketchLine) + (skin_ ? skin_->memory_bytes() : 0);
        const CreatureMeasures all = sum_of(measures_);
        const double feet = static_cast<double>(species_.limbs.size());
        const double frames = static_cast<double>(std::max<std::uint64_t>(1, all.frames));
        report.measure("creatures", static_cast<std::int64_t>(creatures_.size()));
        report.measure("lost_frames", static_cast<std::int64_t>(all.lost_frames));
        report.measure("max_penetration_m", all.worst_penetration);
        report.measure("max_stance_slip_m", all.worst_slip);
        report.measure("mean_feet_down", static_cast<double>(all.feet_down) / frames);
        report.measure("duty_factor", static_cast<double>(all.feet_down) / frames / feet);
        report.measure("stride_m", all.steps > 0 ? all.distance * feet / static_cast<double>(all.steps) : 0);
        report.measure("max_joint_violation_rad", all.worst_joint);
        report.measure("reach_failures", static_cast<std::int64_t>(all.forced_steps));
        report.measure("max_reach_error", all.worst_reach);
        report.measure("footholds_not_found", static_cast<std::int64_t>(all.searches));
        report.measure("min_stability_margin_m", all.frames > 0 ? all.least_margin : 0);
        report.measure("mean_stability_margin_m", all.margins / frames);
        report.measure("unstable_frames", static_cast<std::int64_t>(all.unstable_frames));
        report.measure("penetrating_frames", static_cast<std::int64_t>(all.penetrating_frames));
        report.measure("max_turn_deg_per_s", all.worst_turn / step_);
        report.measure("distance_walked_m", all.distance);
    }

    SkinMesh mesh() override {
        if (!skin_) skin_.emplace(species_, RandomStream{0, species_.name});
        return skin_->mesh();
    }

    bool wanted() const noexcept override { return debug_; }

    std::span<const SketchLine> lines() override {
        lines_.clear();
        for (const CreatureState& creature : creatures_) add_sketch(*surface_, conduct_, creature, lines_);
        return lines_;
    }

    std::span<const SkinMove> moves() override {
        const std::size_t bones = mesh().rods.size();
        moves_.resize(creatures_.size() * bones);
        for (std::size_t i = 0; i < creatures_.size(); ++i) {
            const auto of_one = std::span(moves_).subspan(i * bones, bones);
            skin_->move(skeleton_pose(conduct_, creatures_[i]), of_one);
            to_world(pose_of(conduct_, creatures_[i]), of_one);
        }
        return moves_;
    }

private:
    static constexpr std::size_t kGrain = 8;

    template <class F>
    void for_each(const F& f) {
        auto range = [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) f(i);
        };
        if (workers_ != nullptr)
            workers_->for_each_range(creatures_.size(), kGrain, range);
        else
            range(0, creatures_.size());
    }

    void make_state(Host& host, std::size_t count) {
        position_ = host.state().vectors("position", count, {"m", "middles of the creatures' thoraxes"});
        up_ = host.state().vectors("up", count, {"1", "away from the surface"});
        forward_ = host.state().vectors("forward", count, {"1", "where they look"});
        foot_ = host.state().vectors("foot", count * species_.limbs.size(),
                                     {"m", "where their feet are, leg by leg"});
        per_creature_ = count_numbers(species_.limbs.size());
        numbers_ =
            host.state().scalars("creature", count * per_creature_, {"1", "all that they go on from", false});
        for (std::size_t i = 0; i < count; ++i) random_.push_back(host.random("creature " + std::to_string(i)));
    }

    /// Where a point finds the surface; at random in its bounds where none is asked for.
    bool place(Host& host) {
        const RandomStream random = host.random("places");
        Vec3 low = surface_->vertices()[0], high = low;
        for (const Vec3& v : surface_->vertices()) {
            low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
            high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
        }
        const double far = 2 * norm(high - low) +
                           norm(host.options().has("position") ? host.options().vector("position") : Vec3{});
        for (std::size_t i = 0; i < creatures_.size(); ++i) {
            const bool asked = i == 0 && host.options().has("position");
            const std::uint64_t n = 6 * i;
            const Vec3 point =
                asked ? host.options().vector("position")
                      : Vec3{random.uniform(n, low.x, high.x), random.uniform(n + 1, low.y, high.y),
                             random.uniform(n + 2, low.z, high.z)};
            const Vec3 heading = i == 0 ? host.options().vector("heading")
                                        : Vec3{random.uniform(n + 3, -1, 1), random.uniform(n + 4, -1, 1),
                                               random.uniform(n + 5, -1, 1)};
            const SurfaceHit hit = surface_->closest_point(point, far);
            const Vec3 away = point - surface_->position(hit.at), normal = surface_->normal(hit.at.face);
            const Vec3 up = norm(away) > 1e-9 && dot(away, normal) < 0 ? -1 * normal : normal;
            const SurfaceStep placed = surface_->place(hit.at, up, heading);
            if (hit.answer != Answer::found || placed.answer != Answer::found) {
                host.report_fault({host.options().where(asked ? "position" : "count"),
                                   "creature " + std::to_string(i) + " finds no place on the surface", "", ""});
                return false;
            }
            place_creature(*surface_, conduct_, placed.end, creatures_[i]);
        }
        return true;
    }

    void advance_one(std::size_t i, double reach, double dt) noexcept {
        std::array<Vec3, 16> near;
        const std::size_t count = creatures_.size() > 1 ? neighbors_.around(i, near) : 0;
        advance_creature(*surface_, conduct_, {random_[i], std::span(near).first(count), reach}, dt,
                         creatures_[i], measures_[i]);
    }

    /// Only when all have advanced: they look at where others were.
    void keep_state() {
        const std::size_t legs = species_.limbs.size();
        for_each([&](std::size_t i) {
            const BodyPose pose = pose_of(conduct_, creatures_[i]);
            position_[i] = pose.position;
            up_[i] = pose.up;
            forward_[i] = pose.forward;
            for (std::size_t leg = 0; leg < legs; ++leg) foot_[i * legs + leg] = creatures_[i].feet[leg].place;
            write_numbers(creatures_[i], legs, &numbers_[i * per_creature_]);
        });
    }

    Species species_;
    std::optional<LegLanes> lanes_;
    std::optional<LegWays> ways_;
    Conduct conduct_;
    bool debug_ = false;
    const Surface* surface_ = nullptr;
    Workers* workers_ = nullptr;
    std::vector<RandomStream> random_;
    std::vector<CreatureState> creatures_;
    std::vector<CreatureMeasures> measures_;
    Neighbors neighbors_;
    std::optional<Skin> skin_;  // made when somebody looks
    std::vector<SkinMove> moves_;
    std::vector<SketchLine> lines_;
    std::span<Vec3> position_, up_, forward_, foot_;  // state
    std::span<double> numbers_;                       // state
    std::size_t per_creature_ = 0;
    double step_ = 1;  // s, of a frame
};

}  // namespace
}  // namespace orbweaver::spider

ORBWEAVER_MODULE(orbweaver::spider::SpiderModule)
