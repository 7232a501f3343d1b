#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "crawl.hpp"
#include "mass_spring/simulation.hpp"

/// Bodies that crawl on a ground, run frame by frame.
namespace crawling {

using namespace orbweaver;
using namespace orbweaver::crawler;

struct Setup {
    Build build;
    std::uint32_t bodies = 1;
    const char* gait = "rectilinear";
    WaveForm form = WaveForm::sine;
    double waves = 2;
    double period = 2;  ///< s
    Effort effort;      ///< full, after the first cycle
    Friction friction;
    Ground ground = Floor{0};
    const char* method = "symplectic_euler";
    double step = 0;  ///< s; 0: as advised
    mass_spring::OnUnstable on_unstable = mass_spring::OnUnstable::substep;
    std::int64_t max_substeps = 100000;
    double frame = 1 / 60.;  ///< s
    Vec3 gravity{0, -9.81, 0};
    double drag = 0;          ///< N s/m
    std::vector<Pose> poses;  ///< none: on the floor along x
    Workers* workers = nullptr;

    /// Springs as stiff and as damped as these many masses of a point over a time and its square. The
    /// body is as dense as water.
    void make_springs(double stiffness, double damping, double seconds) {
        build.mass = 1000 * build.length * build.width * build.width;
        const double mass = build.point_mass();
        build.stiffness = stiffness * mass / (seconds * seconds);
        build.damping = damping * mass / seconds;
    }
};

class Run {
public:
    explicit Run(const Setup& setup)
        : setup_(setup),
          lattice_{setup.bodies, setup.build.segments},
          network_(make_network(lattice_, setup.build)),
          x(straight_points(lattice_, setup.build, poses())),
          v(x.size()),
          reaction(x.size()),
          turned(x.size()),
          step_x(x),
          step_v(x.size()),
          system(network_, setup.workers),
          waves_(*find_gait(setup.gait), setup.form, setup.waves, setup.build.segments),
          crawl(system, lattice_, setup.build, waves_, setup.friction, setup.ground,
                {reaction, turned, step_x, step_v}, *mass_spring::find_method(setup.method), setup.workers),
          drives_(setup.bodies) {
        system.set_surroundings({setup.gravity, setup.drag, {}});
        mass_spring::SimulationSettings settings;
        settings.method = mass_spring::find_method(setup.method);
        settings.step = setup.step;
        settings.on_unstable = setup.on_unstable;
        settings.max_substeps = setup.max_substeps;
        settings.warn = [this](const std::string&) { ++warnings; };
        begin();
        simulation_.emplace(system, settings, setup.frame, x, v);
    }

    void begin() {
        for (Drive& drive : drives_)
            for (int i = 0; i < 2; ++i) {
                const double time = (static_cast<double>(frame) + i) * setup_.frame;
                const double ramp = std::min(1.0, time / setup_.period);
                const double share = ramp * ramp * (3 - 2 * ramp);
                drive.cycles[i] = time / setup_.period;
                drive.effort[i] = {share * setup_.effort.strain, share * setup_.effort.bend,
                                   share * setup_.effort.lift, share * setup_.effort.turn};
            }
        crawl.begin_frame(drives_, x, v, setup_.frame);
    }
    void advance() {
        begin();
        simulation_->advance(frame, static_cast<double>(frame) * setup_.frame);
        ++frame;
    }
    void advance(double seconds) {
        for (long count = std::lround(seconds / setup_.frame); count > 0; --count) advance();
    }

    const Lattice& lattice() const { return lattice_; }
    std::span<const Vec3> body(std::uint32_t which = 0) const {
        return std::span(x).subspan(lattice_.point(which, 0), lattice_.points_a_body());
    }
    /// m, of the first body's mass.
    Vec3 center() const { return mean(x); }
    Vec3 velocity() const { return mean(v); }
    double mass() const { return setup_.build.mass; }
    /// J, of all bodies, springs as the frame's end has them.
    mass_spring::Energy energy() {
        begin();
        crawl.rewind();
        return system.energy(x, v);
    }
    const Books& books() const { return crawl.books(); }
    /// m, of the lowest point.
    double lowest() const {
        return std::min_element(x.begin(), x.end(), [](const Vec3& a, const Vec3& b) { return a.y < b.y; })->y;
    }
    /// J, from nowhere.
    double energy_gain() const { return simulation_->energy_gain(); }
    /// m
    double error_estimate() const { return simulation_->error_estimate(); }

private:
    std::vector<Pose> poses() const {
        if (!setup_.poses.empty()) return setup_.poses;
        std::vector<Pose> poses;
        for (std::uint32_t i = 0; i < setup_.bodies; ++i)
            poses.push_back({{0, setup_.build.width / 2, 0.05 * i}, {1, 0, 0}, {0, 1, 0}});
        return poses;
    }
    Vec3 mean(const std::vector<Vec3>& of) const {
        Vec3 sum;
        double mass = 0;
        for (std::size_t i = 0; i < lattice_.points_a_body(); ++i) {
            sum += network_.mass[i] * of[i];
            mass += network_.mass[i];
        }
        return sum / mass;
    }

    Setup setup_;
    Lattice lattice_;
    mass_spring::Network network_;

public:
    std::vector<Vec3> x, v, reaction, turned, step_x, step_v;
    std::uint64_t frame = 0;
    int warnings = 0;
    mass_spring::SpringSystem system;

private:
    Waves waves_;

public:
    Crawl crawl;

private:
    std::vector<Drive> drives_;
    std::optional<mass_spring::Simulation> simulation_;
};

}  // namespace crawling
