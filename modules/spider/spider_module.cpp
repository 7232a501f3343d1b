#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "conduct_options.hpp"
#include "creature.hpp"
#include "creature_numbers.hpp"
#include "leg_ways.hpp"
#include "manifest_text.hpp"
#include "neighbors.hpp"
#include "orbweaver/contracts/creatures.hpp"
#include "orbweaver/contracts/input.hpp"
#include "orbweaver/contracts/skins.hpp"
#include "orbweaver/contracts/workers.hpp"
#include "orbweaver/entry.hpp"
#include "orbweaver/fault.hpp"
#include "places.hpp"
#include "sketch.hpp"
#include "skin.hpp"

namespace orbweaver::spider {
namespace {

/// One [spider] table: creatures of one kind.
class SpiderModule final : public Module, public Skins, public Sketch, public Creatures {
public:
    void attach(Host& host) override {
        Diagnostics faults;
        auto species = read_species_file(host.options().text("species"), faults);
        for (Diagnostic& fault : faults) host.report_fault(std::move(fault));
        if (!species) return;
        species_ = std::move(*species);
        surface_ = host.find<Surface>();
        workers_ = host.find<Workers>();
        conduct_ = conduct_of(host, *surface_, species_);
        if (host.options().text("ik") == "half_jacobian") conduct_.lanes = &lanes_.emplace(legs_of(species_));
        debug_ = host.options().flag("debug");
        step_ = host.scene().step;
        script_ = control_of(host.options());
        name_ = host.options().has("name") ? host.options().text("name") : host.instance_name();
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
        host.provide<Creatures>(*this);
    }

    void meet(Host& host) override {
        const std::vector<Creatures*> groups = host.collect<Creatures>();
        quarries_ = groups_named(host, "pursue.target", groups);
        hunters_ = groups_named(host, "evade.target", groups);
        for (const Creatures* group : groups)
            if (group != this && std::find(quarries_.begin(), quarries_.end(), group) == quarries_.end())
                others_.push_back(group);
        if (host.options().flag("keys")) keys_ = host.find<Input>();
    }

    void run(Phase, const orbweaver::Frame& frame) override {
        gather_crowd();
        const std::optional<Command> command = command_now(frame.time);
        orients_ = frame.index % conduct_.orient_every == 0;
        for_each([&](std::size_t i) { advance_one(i, i == 0 ? command : std::nullopt, frame.step); });
        check_state(frame);
        keep_state();
    }

    void restored() override {
        for (std::size_t i = 0; i < creatures_.size(); ++i) {
            read_numbers(&numbers_[i * per_creature_], species_.limbs.size(), creatures_[i]);
            if (!stands_on(*surface_, creatures_[i]))
                throw Fault(FaultKind::invalid,
                            "creature " + std::to_string(i) + " of '" + name_ +
                                "' does not stand on this surface: the state was saved on another one");
        }
    }

    void report(ModuleReport& report) override {
        report.memory_bytes = creatures_.capacity() * (sizeof(CreatureState) + sizeof(CreatureMeasures)) +
                              crowd_.capacity() * sizeof(Vec3) + neighbors_.memory_bytes() +
                              memory_bytes(conduct_.behaviors) + moves_.capacity() * sizeof(SkinMove) +
                              lines_.capacity() * sizeof(SketchLine) + (skin_ ? skin_->memory_bytes() : 0);
        const CreatureMeasures all = sum_of(measures_);
        const double feet = static_cast<double>(species_.limbs.size());
        const double frames = static_cast<double>(std::max<std::uint64_t>(1, all.frames));
        report.measure("creatures", static_cast<std::int64_t>(creatures_.size()));
        report.measure("lost_frames", static_cast<std::int64_t>(all.lost_frames));
        report.measure("turned_aside_frames", static_cast<std::int64_t>(all.turned_aside));
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

    std::string_view name() const noexcept override { return name_; }
    std::span<const Vec3> positions() const noexcept override { return position_; }
    std::span<const Vec3> velocities() const noexcept override { return velocity_; }

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
        velocity_ = host.state().vectors("velocity", count, {"m/s", "along the surface"});
        up_ = host.state().vectors("up", count, {"1", "away from the surface"});
        forward_ = host.state().vectors("forward", count, {"1", "where they look"});
        foot_ = host.state().vectors("foot", count * species_.limbs.size(),
                                     {"m", "where their feet are, leg by leg"});
        per_creature_ = count_numbers(species_.limbs.size());
        numbers_ =
            host.state().scalars("creature", count * per_creature_, {"1", "all that they go on from", false});
        for (std::size_t i = 0; i < count; ++i) random_.push_back(host.random("creature " + std::to_string(i)));
    }

    /// The first one where it is asked for, all others at random.
    bool place(Host& host) {
        const Options& options = host.options();
        Places places(*surface_, conduct_.gravity, conduct_.behaviors.apart, host.random("places"));
        for (std::size_t i = 0; i < creatures_.size(); ++i) {
            const bool asked = i == 0 && options.has("position");
            std::optional<Vec3> heading;
            if (i == 0) heading = options.vector("heading");
            const Places::Found found = asked ? places.near(options.vector("position"), *heading)
                                              : places.at_random(i, creatures_.size(), heading);
            if (!found.holds) {
                const bool there = found.place.answer == Answer::found;
                host.report_fault({options.where(asked ? "position" : "count"),
                                   "creature " + std::to_string(i) +
                                       (!asked  ? " finds no place on the surface to hold on to"
                                        : there ? " cannot hold on to the surface where it is placed"
                                                : " has no surface to stand on where it is placed"),
                                   "", ""});
                return false;
            }
            place_creature(*surface_, conduct_, found.place.end, creatures_[i]);
            places.take(found.place.end.position);
        }
        return true;
    }

    using Groups = std::vector<const Creatures*>;

    /// All groups of the name that an option gives.
    static Groups groups_named(Host& host, const char* key, const std::vector<Creatures*>& groups) {
        Groups found;
        if (!host.options().has(key)) return found;
        const std::string& name = host.options().text(key);
        std::string names;
        for (const Creatures* group : groups) {
            if (group->name() == name) found.push_back(group);
            names += names.empty() ? "" : ", ";
            names += group->name();
        }
        if (found.empty())
            host.report_fault({host.options().where(key), "no creatures are called '" + name + "'",
                               "one of " + names, "give them a name in their table"});
        return found;
    }

    std::optional<Agent> nearest_in(const Groups& groups, std::size_t i) const noexcept {
        const Vec3& here = creatures_[i].ground.footing.position;
        std::optional<Agent> nearest;
        for (const Creatures* group : groups) {
            const auto other = nearest_of(*group, here, group == this ? i : SIZE_MAX);
            const bool nearer =
                other && (!nearest || distance(other->position, here) < distance(nearest->position, here));
            if (nearer) nearest = other;
        }
        return nearest;
    }

    /// Whom these keep away from: each other, and all others but those they hunt.
    void gather_crowd() {
        if (conduct_.behaviors.keep_apart == 0 || creatures_.size() + others_.size() == 1) return;
        crowd_.assign(position_.begin(), position_.end());
        for (const Creatures* group : others_)
            crowd_.insert(crowd_.end(), group->positions().begin(), group->positions().end());
        neighbors_.gather(crowd_, conduct_.behaviors.apart);
    }

    std::optional<Command> command_now(double time) const {
        const Command fastest{conduct_.pace.top_speed, conduct_.turn_rate};
        std::optional<Command> command;
        if (keys_ != nullptr) command = command_of_keys(keys_->latest().walk, keys_->latest().turn, fastest);
        return command ? command : command_in<Command>(script_, time);
    }

    void advance_one(std::size_t i, const std::optional<Command>& command, double dt) noexcept {
        std::array<Vec3, 16> near;
        const std::size_t count = crowd_.empty() ? 0 : neighbors_.around(i, near);
        const Company company{random_[i],
                              std::span(near).first(count),
                              nearest_in(quarries_, i),
                              nearest_in(hunters_, i),
                              command,
                              orients_};
        advance_creature(*surface_, conduct_, company, dt, creatures_[i], measures_[i]);
    }

    /// Nothing leaves that is not finite: what is kept is the state of the frame before.
    void check_state(const orbweaver::Frame& frame) const {
        for (std::size_t i = 0; i < creatures_.size(); ++i)
            if (const char* what = not_finite(conduct_, creatures_[i]))
                throw Fault(FaultKind::diverged, "creature " + std::to_string(i) + " of '" + name_ + "': its " +
                                                     what +
                                                     " is not finite after t = " + std::to_string(frame.time) +
                                                     " s, in a step of " + std::to_string(frame.step) + " s");
    }

    /// Only when all have advanced: they look at where others were.
    void keep_state() {
        const std::size_t legs = species_.limbs.size();
        for_each([&](std::size_t i) {
            const BodyPose pose = pose_of(conduct_, creatures_[i]);
            position_[i] = pose.position;
            velocity_[i] = creatures_[i].ground.velocity;
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
    std::string name_;
    std::vector<TimedCommand> script_;
    const Input* keys_ = nullptr;
    Groups quarries_, hunters_, others_;
    std::vector<Vec3> crowd_;  // m, of these first; none where nobody keeps apart
    Neighbors neighbors_;
    std::optional<Skin> skin_;  // made when somebody looks
    std::vector<SkinMove> moves_;
    std::vector<SketchLine> lines_;
    std::span<Vec3> position_, velocity_, up_, forward_, foot_;  // state
    std::span<double> numbers_;                                  // state
    std::size_t per_creature_ = 0;
    double step_ = 1;      // s, of a frame
    bool orients_ = true;  // in this frame
};

}  // namespace
}  // namespace orbweaver::spider

ORBWEAVER_MODULE(orbweaver::spider::SpiderModule)
