#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "crawl.hpp"
#include "crawler_options.hpp"
#include "manifest_text.hpp"
#include "mass_spring/simulation.hpp"
#include "orbweaver/contracts/creatures.hpp"
#include "orbweaver/contracts/input.hpp"
#include "orbweaver/contracts/patches.hpp"
#include "orbweaver/entry.hpp"
#include "pilot.hpp"
#include "sketch.hpp"
#include "skin.hpp"

namespace orbweaver::crawler {
namespace {

/// Of all bodies together.
struct Account {
    double start_energy = 0;  ///< J, at the start
    double now = 0;           ///< s, that they crawled
    Books books;
};
/// That and pilots are kept as numbers.
template <class T>
constexpr std::size_t kNumbers = sizeof(T) / sizeof(double);

/// Change of a body's volume by which it is no longer a bar.
constexpr double kCrushed = 0.5;

/// One [crawler] table: bodies of one kind.
class CrawlerModule final : public Module, public Creatures, public Patches, public Sketch {
public:
    void attach(Host& host) override {
        Diagnostics faults;
        gravity_ = host.scene().gravity;
        crawler_ = read_crawler(host.options(), gravity_, faults);
        const Surface* surface = host.find<Surface>();
        workers_ = host.find<Workers>();
        Ground ground = read_ground(host.options(), crawler_, surface, workers_, faults);
        const std::vector<Vec3> places = read_places(host.options(), crawler_, surface, faults);
        const bool sound = faults.empty();
        for (Diagnostic& fault : faults) host.report_fault(std::move(fault));
        if (!sound) return;
        name_ = host.options().has("name") ? host.options().text("name") : host.instance_name();
        kind_ = host.options().has("kind") ? host.options().text("kind") : crawler_.gait->name;
        lattice_ = {crawler_.count, crawler_.build.segments};
        network_ = make_network(lattice_, crawler_.build);
        frame_step_ = host.scene().step;
        make_state(host, places);
        if (const auto* cliff = std::get_if<Cliff>(&ground)) cliff_ = *cliff;
        make_system(host, std::move(ground));
        offer_telemetry(host);
        host.provide<Creatures>(*this);
        host.provide<Patches>(*this);
        host.provide<Sketch>(*this);
        debug_ = host.options().flag("debug");
    }

    void meet(Host& host) override {
        if (host.options().flag("keys")) keys_ = host.find<Input>();
    }

    void run(Phase phase, const Frame& frame) override {
        if (phase == Phase::act) {
            for (std::uint32_t body = 0; body < lattice_.bodies; ++body)
                drives_[body] =
                    go_on(crawler_, command_for(body, frame.time), frame.time, frame.step, pilots_[body]);
        } else {
            crawl_->begin_frame(drives_, position_, velocity_, frame.step);
            simulation_->advance(frame.index, frame.time);
            note(frame.time + frame.step);
        }
    }

    void restored() override {
        read_pilots();
        crawl_->set_books(account_.books);
        for (std::uint32_t body = 0; body < lattice_.bodies; ++body) look_at(body);
        stand();
    }

    void report(ModuleReport& report) override {
        report.method = crawler_.settings.method->name;
        report.steps = simulation_->steps();
        report.memory_bytes = memory_bytes();
        report.has_error = true;
        report.error = {simulation_->error_estimate(), "m", simulation_->error_method(),
                        simulation_->error_seconds()};
        stand();
        report_body(report);
        report_motion(report);
        report_energy(report);
        const mass_spring::Advice& advice = simulation_->advice();
        report.measure("stable_step_s", advice.stable_step);
        report.measure("stable_step_spring", advice.has_spring ? describe_spring(advice.spring) : "none");
    }

    std::string_view name() const noexcept override { return name_; }
    std::span<const Vec3> positions() const noexcept override { return centers_; }
    std::span<const Vec3> velocities() const noexcept override { return center_velocities_; }

    bool wanted() const noexcept override { return debug_ || cliff_; }
    std::span<const SketchLine> lines() override {
        lines_.clear();
        if (cliff_) add_cliff(*cliff_, 1.5 * crawler_.build.length, lines_);
        if (debug_) add_sketch(lattice_, crawler_.build, norm(gravity_), position_, trace_.reaction, lines_);
        return lines_;
    }

    PatchLayout layout() const noexcept override { return skin_layout(lattice_); }
    PatchMap map() override {
        if (!skin_) skin_.emplace(kind_, lattice_, crawler_.build);
        return skin_->map();
    }
    std::span<const Vec3> points() override {
        map();
        return skin_->points(position_);
    }

private:
    /// Springs and ground become those of this moment, whatever was tried since.
    void stand() {
        for (std::uint32_t body = 0; body < lattice_.bodies; ++body)
            drives_[body] = hold(crawler_, pilots_[body], account_.now);
        crawl_->begin_frame(drives_, position_, velocity_, frame_step_);
        crawl_->rewind();
    }

    void make_state(Host& host, const std::vector<Vec3>& places) {
        StateStore& state = host.state();
        const std::size_t count = lattice_.points();
        position_ = state.vectors("position", count, {"m", "masses: four a ring, rings from tail to head"});
        velocity_ = state.vectors("velocity", count, {"m/s", "of the masses"});
        trace_ = {state.vectors("reaction", count, {"N", "by which the ground presses on each mass", false}),
                  state.vectors("turned", count, {"m/s", "by which the ground turned each mass last", false}),
                  state.vectors("step_position", count, {"m", "of the masses as the last step began", false}),
                  state.vectors("step_velocity", count, {"m/s", "likewise", false})};
        substep_ = state.scalars("substep", mass_spring::kSimulationMemory,
                                 {"s", "step in use, and the mark of its method", false});
        numbers_ = state.scalars("pilot", lattice_.bodies * kNumbers<Pilot> + kNumbers<Account>,
                                 {"1", "all else that they go on from, and their books", false});
        std::copy(places.begin(), places.end(), position_.begin());
    }

    void make_system(Host& host, Ground ground) {
        system_ = std::make_unique<mass_spring::SpringSystem>(network_, workers_);
        system_->set_surroundings({gravity_, crawler_.drag, {}});
        system_->use_linear_solver(crawler_.linear_solver);
        crawl_.emplace(*system_, lattice_, crawler_.build,
                       Waves(*crawler_.gait, crawler_.form, crawler_.waves, lattice_.segments),
                       crawler_.friction, std::move(ground), trace_, *crawler_.settings.method, workers_);
        drives_.resize(lattice_.bodies);
        pilots_.resize(lattice_.bodies);
        centers_.resize(lattice_.bodies);
        center_velocities_.resize(lattice_.bodies);
        rest_volume_ = volume(lattice_, body_points(0));
        crawl_->lift_out(position_);
        crawl_->lay_down(position_);
        std::copy(position_.begin(), position_.end(), trace_.x.begin());
        for (Drive& drive : drives_) drive = hold(crawler_, {}, 0);
        crawl_->begin_frame(drives_, position_, velocity_, frame_step_);
        crawl_->rewind();
        for (std::uint32_t body = 0; body < lattice_.bodies; ++body) {
            look_at(body);
            pilots_[body].journey.start = pilots_[body].journey.mark = centers_[body];
        }
        crawler_.settings.describe_spring = [this](std::size_t i) { return describe_spring(i); };
        crawler_.settings.warn = [&host](const std::string& sentence) {
            host.log(LogLevel::warning, sentence);
        };
        crawler_.settings.stop_asked = [&host] { return host.stop_asked(); };
        if (crawler_.settings.step == 0) choose_step();
        simulation_ = std::make_unique<mass_spring::Simulation>(*system_, crawler_.settings, frame_step_,
                                                                position_, velocity_, substep_);
        warn_of_period();
        account_.start_energy = kept_energy();
        write_pilots();
    }

    void warn_of_period() {
        constexpr double kFewest = 10;
        const double step = simulation_->substep();
        if (crawler_.period >= kFewest * step) return;
        crawler_.settings.warn(
            fmt::format("a 'period' of {:.3g} s is shorter than {} steps of {:.3g} s, which do "
                        "not resolve its waves; ask for a longer one, or a shorter 'step'",
                        crawler_.period, kFewest, step));
    }

    /// Well within what the springs alone allow, by symplectic Euler too: whatever the method, the ground acts
    /// between its steps, and what lands on it must not be strained much before it is met. What sticks to the
    /// ground is held by the reaction of the step before, d' = -(h omega)^2 d of its moves d: it is still where
    /// h omega < 1, omega of the point alone, whose neighbors stand still. In the fastest vibration they move
    /// against it, so that it has up to twice that stiffness, and it is stable up to h omega = 2: steps may be
    /// sqrt(1/2) of those.
    void choose_step() {
        constexpr double kShare = 0.7, kForever = std::numeric_limits<double>::infinity();
        // All bodies are alike.
        const Lattice one{1, lattice_.segments};
        const mass_spring::Network network = make_network(one, crawler_.build);
        mass_spring::SpringSystem springs(network, nullptr);
        springs.set_surroundings({gravity_, crawler_.drag, {}});
        const auto stable = [&](const mass_spring::MethodInfo& method) {
            const double step = advise(springs, body_points(0), method).stable_step;
            return step > 0 ? step : kForever;
        };
        const mass_spring::MethodInfo* method = crawler_.settings.method;
        const mass_spring::MethodInfo* common = mass_spring::find_method("symplectic_euler");
        const double step = std::min(stable(*common), method == common ? kForever : stable(*method));
        if (std::isfinite(step)) crawler_.settings.step = kShare * step;
    }

    void offer_telemetry(Host& host) {
        host.telemetry("work_j", [this] { return crawl_->books().muscles; });
        host.telemetry("friction_loss_j", [this] { return crawl_->books().friction; });
        host.telemetry("forward_speed_m_s", [this] {
            double sum = 0;
            for (std::uint32_t body = 0; body < lattice_.bodies; ++body)
                sum += dot(center_velocities_[body], heading(body).forward);
            return sum / lattice_.bodies;
        });
    }

    std::span<const Vec3> body_points(std::uint32_t body) const noexcept {
        return std::span<const Vec3>(position_).subspan(lattice_.point(body, 0), lattice_.points_a_body());
    }

    Pose heading(std::uint32_t body) const noexcept {
        return heading_of(lattice_, body_points(body), centers_[body]);
    }

    /// The first one may be told by hand.
    Command command_for(std::uint32_t body, double time) const {
        if (body == 0 && keys_ != nullptr) {
            const InputEvents& held = keys_->latest();
            return {static_cast<double>(held.walk), static_cast<double>(held.turn)};
        }
        const auto told = body == 0 ? command_in<Command>(crawler_.script, time) : std::nullopt;
        return told ? *told : own_command(crawler_, heading(body));
    }

    void look_at(std::uint32_t body) noexcept {
        const std::size_t first = lattice_.point(body, 0);
        double mass = 0;
        Vec3 place, momentum;
        for (std::size_t i = first; i < first + lattice_.points_a_body(); ++i) {
            mass += network_.mass[i];
            place += network_.mass[i] * position_[i];
            momentum += network_.mass[i] * velocity_[i];
        }
        centers_[body] = place / mass;
        center_velocities_[body] = momentum / mass;
    }

    void note(double now) {
        account_.books = crawl_->books();
        for (std::uint32_t body = 0; body < lattice_.bodies; ++body) {
            look_at(body);
            Pilot& pilot = pilots_[body];
            pilot.journey.go_on(centers_[body], now, pilot.cycles);
            const double change = std::abs(volume(lattice_, body_points(body)) / rest_volume_ - 1);
            pilot.journey.volume_error = std::max(pilot.journey.volume_error, change);
            if (change > kCrushed) warn_of_crushing(body, change, now);
        }
        account_.now = now;
        write_pilots();
    }

    void warn_of_crushing(std::uint32_t body, double change, double now) {
        if (!warned_of_crushing_)
            crawler_.settings.warn(
                fmt::format("crawler {} is crushed or turned inside out at t = {:.4g} s: its volume changed by "
                            "{:.0f} %; stiffer "
                            "springs (a higher 'strength', a shorter 'time_unit') would keep it whole",
                            body, now, 100 * change));
        warned_of_crushing_ = true;
    }

    void write_pilots() noexcept {
        const auto* pilots = reinterpret_cast<const double*>(pilots_.data());
        const auto* account = reinterpret_cast<const double*>(&account_);
        std::copy_n(account, kNumbers<Account>,
                    std::copy_n(pilots, pilots_.size() * kNumbers<Pilot>, numbers_.begin()));
    }
    void read_pilots() noexcept {
        const std::size_t pilots = pilots_.size() * kNumbers<Pilot>;
        std::copy_n(numbers_.begin(), pilots, reinterpret_cast<double*>(pilots_.data()));
        std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(pilots), kNumbers<Account>,
                    reinterpret_cast<double*>(&account_));
    }

    void report_body(ModuleReport& report) const {
        report.measure("crawlers", static_cast<std::int64_t>(lattice_.bodies));
        report.measure("particles", static_cast<std::int64_t>(network_.size()));
        report.measure("springs", static_cast<std::int64_t>(network_.springs.size()));
        report.measure("body_mass_kg", crawler_.build.mass);
    }

    void report_motion(ModuleReport& report) const {
        double speed = 0, way = 0, volume_error = 0;
        for (std::uint32_t body = 0; body < lattice_.bodies; ++body) {
            const Journey& journey = pilots_[body].journey;
            speed += journey.speed(centers_[body], account_.now) / lattice_.bodies;
            way += journey.way_a_cycle(centers_[body], pilots_[body].cycles) / lattice_.bodies;
            volume_error = std::max(volume_error, journey.volume_error);
        }
        const Books& books = crawl_->books();
        report.measure("mean_speed_m_s", speed);
        report.measure("lengths_per_cycle", way / crawler_.build.length);
        report.measure("waves_per_length", crawler_.waves);
        report.measure("max_volume_error", volume_error);
        report.measure("mean_slip_m_s", books.contact > 0 ? books.slip / books.contact : 0);
        report.measure("points_on_ground",
                       account_.now > 0 ? books.contact / account_.now / lattice_.bodies : 0);
    }

    /// J, as the books have it: velocities are brought to where positions are, without what the ground gave
    /// them last, which springs answer in the next step.
    double kept_energy() const {
        double energy = system_->energy(position_, velocity_).total();
        const mass_spring::MethodInfo& method = *crawler_.settings.method;
        const double ahead = method.velocity_lag * simulation_->substep();
        std::vector<Vec3> force(position_.size());
        system_->forces(position_, velocity_, force);
        for (std::size_t i = 0; i < force.size(); ++i) {
            const Vec3 given = force[i] - system_->external_force(i);
            energy += ahead * dot(given, velocity_[i] - trace_.turned[i]);
        }
        return energy;
    }

    void report_energy(ModuleReport& report) {
        const Books& books = crawl_->books();
        const double change = kept_energy() - account_.start_energy;
        const double rest = books.muscles - books.friction - books.impact - books.damping - change;
        const double moved = std::abs(books.muscles) + std::abs(change);
        const double share = moved > 0 ? std::abs(rest) / moved : 0;
        double way = 0;
        for (const Pilot& pilot : pilots_) way += pilot.journey.way;
        report.measure("work_in_j", books.muscles);
        report.measure("friction_loss_j", books.friction);
        report.measure("impact_loss_j", books.impact);
        report.measure("lift_gain_j", books.lift);
        report.measure("damping_loss_j", books.damping);
        report.measure("energy_change_j", change);
        report.measure("unexplained_energy_j", rest);
        report.measure("unexplained_share", share);
        report.measure("energy_gain_j", simulation_->energy_gain());
        if (way > 0 && norm(gravity_) > 0)
            report.measure("cost_of_transport", books.muscles / (crawler_.build.mass * norm(gravity_) * way));
        warn_of_books(rest, share);
    }

    /// Not of what is nothing beside bodies' weight.
    void warn_of_books(double rest, double share) {
        constexpr double kMuch = 0.1, kNothing = 1e-3;
        const double weight = lattice_.bodies * crawler_.build.mass * norm(gravity_);
        if (!(share > kMuch) || !(std::abs(rest) > kNothing * weight * crawler_.build.width)) return;
        const std::string_view method = crawler_.settings.method->name;
        crawler_.settings.warn(fmt::format(
            "{:.3g} J of the crawlers' energy, {:.0f} % of what muscles did and motion changed by, "
            "are unexplained: steps of {:.3g} s of '{}' do not resolve what happened; ask for a "
            "shorter 'step'{}",
            std::abs(rest), 100 * share, simulation_->substep(), method,
            method == "symplectic_euler" ? "" : ", or for symplectic_euler, whose books close best"));
    }

    std::string describe_spring(std::size_t i) const {
        const mass_spring::Spring& spring = network_.springs[i];
        const std::size_t body = i / lattice_.springs_a_body(), within = i % lattice_.springs_a_body();
        constexpr std::size_t kEach = Lattice::kRingSprings + Lattice::kSegmentSprings;
        const bool of_ring = within % kEach < Lattice::kRingSprings;
        return fmt::format("spring {} ({} {} of crawler {}, particles {} and {})", i,
                           of_ring ? "ring" : "segment", within / kEach, body, spring.a, spring.b);
    }

    std::size_t memory_bytes() const noexcept {
        return simulation_->memory_bytes() + crawl_->memory_bytes() +
               network_.springs.capacity() * sizeof(mass_spring::Spring) +
               network_.mass.capacity() * sizeof(double) + network_.fixed.capacity() +
               pilots_.capacity() * sizeof(Pilot) + drives_.capacity() * sizeof(Drive) +
               (centers_.capacity() + center_velocities_.capacity()) * sizeof(Vec3) +
               lines_.capacity() * sizeof(SketchLine) + (skin_ ? skin_->memory_bytes() : 0);
    }

    Vec3 gravity_;  // m/s^2
    Crawler crawler_;
    std::string name_, kind_;
    Lattice lattice_;
    mass_spring::Network network_;
    double frame_step_ = 0;                          // s
    std::span<Vec3> position_, velocity_;            // state
    StepTrace trace_;                                // state, N
    std::span<double> substep_, numbers_;            // state
    std::vector<Pilot> pilots_;                      // as numbers_ has them
    Account account_;                                // likewise
    std::vector<Vec3> centers_, center_velocities_;  // m, m/s, of mass
    std::vector<Drive> drives_;
    double rest_volume_ = 1;  // m^3
    bool warned_of_crushing_ = false;
    Workers* workers_ = nullptr;
    const Input* keys_ = nullptr;
    std::unique_ptr<mass_spring::SpringSystem> system_;
    std::optional<Crawl> crawl_;
    std::unique_ptr<mass_spring::Simulation> simulation_;
    std::optional<Skin> skin_;  // made when somebody looks
    bool debug_ = false;
    std::optional<Cliff> cliff_;  // which no other module draws
    std::vector<SketchLine> lines_;
};

}  // namespace
}  // namespace orbweaver::crawler

ORBWEAVER_MODULE(orbweaver::crawler::CrawlerModule)
