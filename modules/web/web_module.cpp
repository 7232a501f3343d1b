#include <fmt/format.h>

#include <memory>

#include "draft.hpp"
#include "manifest_text.hpp"
#include "mass_spring/method_choice.hpp"
#include "mass_spring/simulation.hpp"
#include "measures.hpp"
#include "motion_options.hpp"
#include "orbweaver/contracts/inscriber.hpp"
#include "orbweaver/contracts/threads.hpp"
#include "orbweaver/contracts/wind_field.hpp"
#include "orbweaver/contracts/workers.hpp"
#include "orbweaver/entry.hpp"
#include "web_options.hpp"

namespace orbweaver::web {

/// One [web] table: builds the web, moves it frame by frame, and shows its threads.
class WebModule final : public Module, public Threads {
public:
    void attach(Host& host) override {
        Diagnostics faults;
        auto web = build_web(host.options(), host.scene().gravity, host.random("irregularity"), faults);
        Motion motion = read_motion(host.options(), faults);
        if (web) check_damping(host.options(), motion, web->network, faults);
        const bool sound = faults.empty();
        for (Diagnostic& fault : faults) host.report_fault(std::move(fault));
        if (!sound || !web) return;
        web_ = std::move(*web);
        const Settling settling{host.scene().gravity, motion.linear_solver, host.find<Workers>()};
        if (auto* inscriber = host.find<Inscriber>(); inscriber != nullptr && web_.layout.is_orb())
            inscribe(*inscriber, settling);
        else if (host.options().flag("settle"))
            settle(host, settling);
        segments_ = segments_of(web_.layout);
        make_state(host);
        if (motion.settings.method == nullptr) make_choice_state(host);
        make_system(host);
        system_->use_linear_solver(motion.linear_solver);
        start_residual_ = residual();
        if (motion.settings.method == nullptr) choose(host, motion);
        settings_ = std::move(motion.settings);
        settings_.describe_spring = [this](std::size_t i) { return describe_spring(i); };
        settings_.warn = [&host](const std::string& sentence) { host.log(LogLevel::warning, sentence); };
        settings_.stop_asked = [&host] { return host.stop_asked(); };
        frame_step_ = host.scene().step;
        make_simulation();
        offer_telemetry(host);
        host.provide<Threads>(*this);
    }

    void run(Phase phase, const Frame& frame) override {
        if (phase == Phase::sense && wind_ != nullptr) sense(frame);
        if (phase == Phase::integrate) simulation_->advance(frame.index, frame.time);
    }

    /// A run goes on with the method that it chose when it began, whatever it would choose now.
    void restored() override {
        if (chosen_method_.empty()) return;
        const mass_spring::MethodInfo* known = mass_spring::find_method(chosen_method_[0]);
        if (known == nullptr || !(chosen_step_[0] > 0))
            throw Fault(FaultKind::invalid, "the state was saved with a method that is not known here");
        const mass_spring::MethodInfo& method = *known;
        if (settings_.method == &method && settings_.step == chosen_step_[0]) return;
        settings_.method = &method;
        settings_.step = chosen_step_[0];
        choice_ = fmt::format("{} at {:.3g} s was chosen by the run that this one goes on from", method.name,
                              settings_.step);
        const double substep = substep_[0];
        const std::vector<double> creep(creep_.begin(), creep_.end());
        make_simulation();
        substep_[0] = substep;
        std::copy(creep.begin(), creep.end(), creep_.begin());
        settings_.warn(choice_ + ": what trials say of this run does not count");
    }

    void report(ModuleReport& report) override {
        report.method = settings_.method->name;
        report.steps = simulation_->steps();
        report.memory_bytes = memory_bytes();
        report.has_error = true;
        report.error = {simulation_->error_estimate(), "m", simulation_->error_method() + promise_,
                        simulation_->error_seconds()};
        report_threads(report);
        if (web_.layout.is_orb()) report_orb(report);
        report.measure("settle_residual_n", start_residual_);
        report.measure("energy_j", energy().total());
        report.measure("energy_gain_j", simulation_->energy_gain());
        const mass_spring::Advice& advice = simulation_->advice();
        if (!choice_.empty()) report.measure("choice", choice_);
        report.measure("stable_step_s", advice.stable_step);
        report.measure("stable_step_spring", advice.has_spring ? describe_spring(advice.spring) : "none");
    }

    std::span<const Vec3> points() const noexcept override { return position_; }
    std::span<const ThreadSegment> segments() const noexcept override { return segments_; }
    std::span<const std::string_view> kinds() const noexcept override { return kKindNames; }
    std::uint64_t revision() const noexcept override { return 0; }

private:
    void make_state(Host& host) {
        const std::size_t count = web_.network.size();
        position_ = host.state().vectors("position", count, {"m", "positions of the web's particles"});
        velocity_ = host.state().vectors("velocity", count, {"m/s", "velocities of the web's particles"});
        substep_ = host.state().scalars("substep", mass_spring::kSimulationMemory,
                                        {"s", "step in use, and the mark of its method", false});
        if (has_arms(web_.network))
            creep_ = host.state().scalars("creep", web_.network.springs.size(),
                                          {"m", "extensions at which the threads' hysteresis bears nothing"});
        std::copy(web_.layout.positions.begin(), web_.layout.positions.end(), position_.begin());
    }

    void make_system(Host& host) {
        system_ = std::make_unique<mass_spring::SpringSystem>(web_.network, host.find<Workers>());
        surroundings_ = {host.scene().gravity, host.options().number("drag"), {}};
        wind_ = host.find<WindField>();
        if (wind_ != nullptr) {
            air_velocity_.resize(position_.size());
            external_.resize(position_.size());
            surroundings_.external = external_;
            for (const Vec3& p : position_) radius_ = std::max(radius_, distance(p, web_.layout.center));
        }
        system_->set_surroundings(surroundings_);
    }

    void make_choice_state(Host& host) {
        chosen_method_ =
            host.state().words("chosen_method", 1, {"1", "hash of the name of the method chosen", false});
        chosen_step_ = host.state().scalars("chosen_step", 1, {"s", "step chosen with it", false});
    }

    void make_simulation() {
        simulation_ = std::make_unique<mass_spring::Simulation>(*system_, settings_, frame_step_, position_,
                                                                velocity_, substep_, creep_);
    }

    void offer_telemetry(Host& host) {
        host.telemetry("energy_j", [this] { return energy().total(); });
        host.telemetry("kinetic_energy_j", [this] { return energy().kinetic; });
        host.telemetry("max_strain", [this] { return measure_threads(web_.network, position_).max_strain; });
    }

    /// By trials in the winds that the run will meet.
    void choose(Host& host, Motion& motion) {
        const SceneInfo& scene = host.scene();
        mass_spring::RunAhead run{
            surroundings_, position_, {}, scene.step, std::max(1.0, scene.duration / scene.step)};
        if (wind_ != nullptr)
            run.load = [&](double time) {
                blow({0, time, scene.step});
                return std::span<const Vec3>(external_);
            };
        const auto choice =
            choose_method(*system_, run, {motion.tolerance, motion.budget, motion.settings.max_substeps});
        motion.settings.method = choice.chosen.method;
        motion.settings.step = choice.chosen.step;
        chosen_method_[0] = mass_spring::method_key(*choice.chosen.method);
        chosen_step_[0] = choice.chosen.step;
        choice_ = choice.sentence;
        promise_ = fmt::format("; trials beforehand had found {:.2g} m", choice.chosen.error);
        host.log(choice.meets_goal ? LogLevel::info : LogLevel::warning, choice_);
    }

    void inscribe(Inscriber& inscriber, const Settling& settling) {
        auto draft = std::make_unique<Draft>(std::move(web_), settling);
        inscriber.inscribe(*draft, *this);
        web_ = draft->web();
        if (inscriber.keeps_draft()) draft_ = std::move(draft);
    }

    void settle(Host& host, const Settling& settling) {
        const auto found = web::settle(web_, settling);
        if (!found.converged)
            host.log(
                LogLevel::warning,
                fmt::format("it did not come to rest: after {} iterations {:.3g} N are left of the {:.3g} N "
                            "sought; it starts moving",
                            found.iterations, found.residual, found.tolerance));
    }

    void sense(const Frame& frame) {
        blow(frame);
        system_->set_surroundings(surroundings_);
    }

    /// What the air pushes with, into external_.
    void blow(const Frame& frame) {
        wind_->sample({frame.time, position_, web_.layout.center, radius_}, air_velocity_, external_);
        for (std::size_t i = 0; i < external_.size(); ++i)
            external_[i] += surroundings_.drag * air_velocity_[i];
    }

    mass_spring::Energy energy() const noexcept { return system_->energy(position_, velocity_); }

    double residual() const {
        const std::vector<Vec3> rest(position_.size());
        std::vector<Vec3> forces(position_.size());
        system_->forces(position_, rest, forces);
        return largest_residual(web_.network, forces);
    }

    void report_threads(ModuleReport& report) const {
        const ThreadMeasures threads = measure_threads(web_.network, position_);
        report.measure("particles", static_cast<std::int64_t>(web_.network.size()));
        report.measure("springs", static_cast<std::int64_t>(web_.network.springs.size()));
        report.measure("silk_length_m", threads.silk_length);
        report.measure("total_mass_kg", threads.total_mass);
        report.measure("max_strain", threads.max_strain);
        report.measure("slack_springs", static_cast<std::int64_t>(threads.slack_springs));
    }

    void report_orb(ModuleReport& report) const {
        const OrbMeasures orb = measure_orb(web_.layout, position_);
        report.measure("radii", static_cast<std::int64_t>(orb.radii));
        report.measure("spiral_turns", orb.spiral_turns);
        report.measure("capture_area_m2", orb.capture_area);
        report.measure("frame_area_m2", frame_area(web_.layout, position_));
        report.measure("mesh_width_m", orb.mesh_width);
        report.measure("asymmetry", orb.asymmetry);
    }

    std::string describe_spring(std::size_t i) const {
        const Piece& piece = web_.layout.pieces[i];
        return fmt::format("spring {} ({}, particles {} and {})", i,
                           kKindNames[static_cast<std::size_t>(piece.kind)], piece.a, piece.b);
    }

    std::size_t memory_bytes() const {
        return system_->memory_bytes() + simulation_->memory_bytes() +
               segments_.size() * sizeof(ThreadSegment) +
               web_.layout.pieces.size() * (sizeof(Piece) + sizeof(mass_spring::Spring)) +
               web_.network.size() * (sizeof(double) + sizeof(Vec3)) +
               (air_velocity_.size() + external_.size()) * sizeof(Vec3);
    }

    Web web_;
    std::unique_ptr<Draft> draft_;  // of a web whose ways of writing are studied
    std::vector<ThreadSegment> segments_;
    std::span<Vec3> position_;                // state, m
    std::span<Vec3> velocity_;                // state, m/s
    std::span<double> substep_;               // state, s
    std::span<double> creep_;                 // state, m; empty where no thread has a hysteresis
    std::span<std::uint64_t> chosen_method_;  // state, see mass_spring::method_key(); empty: it was said
    std::span<double> chosen_step_;           // state, s; empty as well
    std::unique_ptr<mass_spring::SpringSystem> system_;
    std::unique_ptr<mass_spring::Simulation> simulation_;
    mass_spring::SimulationSettings settings_;
    double frame_step_ = 0;  // s
    mass_spring::Surroundings surroundings_;
    std::string choice_;   // of method auto, in words
    std::string promise_;  // what its trials said of the error, in words
    const WindField* wind_ = nullptr;
    std::vector<Vec3> air_velocity_;  // m/s, sampled this frame
    std::vector<Vec3> external_;      // N, of this frame
    double radius_ = 0;               // m, from the center to the farthest particle
    double start_residual_ = 0;       // N
};

}  // namespace orbweaver::web

ORBWEAVER_MODULE(orbweaver::web::WebModule)
