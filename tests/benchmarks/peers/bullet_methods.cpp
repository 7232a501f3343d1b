// The soft body of Bullet (zlib licence), its build in double precision. It projects links one after the other,
// each by a share of what it is off by. That share is set to what a spring of this stiffness moves its ends by
// in one step of implicit Euler; damping along springs Bullet does not have.

#include <BulletSoftBody/btSoftBody.h>

#include <cmath>

#include "contender.hpp"
#include "stopwatch.hpp"

namespace orbweaver::peers {
namespace {

btVector3 bullet(const Vec3& v) { return {v.x, v.y, v.z}; }

class SoftWeb {
public:
    SoftWeb(const Problem& problem, double step) : problem_(&problem), step_(step), body_(&world_) {
        world_.m_gravity = bullet(problem.gravity);
        world_.air_density = 0;
        body_.m_cfg.kDP = problem.drag * step / problem.network.mass[0];  // it has one for all
        body_.appendMaterial();                                           // nodes ask for a first one
        for (std::size_t i = 0; i < problem.x.size(); ++i)
            body_.appendNode(bullet(problem.x[i]), problem.network.fixed[i] != 0 ? 0 : problem.network.mass[i]);
        for (const mass_spring::Spring& s : problem.network.springs) append(s);
        body_.updateConstants();
        body_.m_bUpdateRtCst = false;  // or the next step would take the lengths as laid for those at rest
        for (int i = 0; i < body_.m_links.size(); ++i) set_rest_length(i);
    }

    Run run() {
        const auto count = static_cast<std::int64_t>(std::llround(problem_->duration / step_));
        const Stopwatch watch;
        for (std::int64_t i = 0; i < count; ++i) advance();
        Run run{{}, watch.seconds()};
        for (int i = 0; i < body_.m_nodes.size(); ++i) {
            const btVector3& x = body_.m_nodes[i].m_x;
            run.x.push_back({x.x(), x.y(), x.z()});
        }
        return run;
    }

private:
    void append(const mass_spring::Spring& spring) {
        const auto inverse_mass = [&](std::uint32_t i) {
            return problem_->network.fixed[i] != 0 ? 0 : 1 / problem_->network.mass[i];
        };
        const double reach =
            spring.stiffness * step_ * step_ * (inverse_mass(spring.a) + inverse_mass(spring.b));
        btSoftBody::Material* material = body_.appendMaterial();
        material->m_kLST = reach / (1 + reach);
        body_.appendLink(static_cast<int>(spring.a), static_cast<int>(spring.b), material);
    }

    void set_rest_length(int link) {
        const double rest_length = problem_->network.springs[static_cast<std::size_t>(link)].rest_length;
        body_.m_links[link].m_rl = rest_length;
        body_.m_links[link].m_c1 = rest_length * rest_length;
    }

    void advance() {
        for (int i = 0; i < body_.m_nodes.size(); ++i)
            body_.addForce(bullet(problem_->wind[static_cast<std::size_t>(i)]), i);
        body_.predictMotion(step_);
        body_.solveConstraints();
        body_.integrateMotion();
    }

    const Problem* problem_;
    double step_;
    btSoftBodyWorldInfo world_;
    btSoftBody body_;
};

}  // namespace

Contenders bullet_methods(const Problem& problem) {
    constexpr double kFrame = 1.0 / 60;  // s
    return {{"Bullet soft body", "its own", "step", kFrame, step_ratio(1), [&problem](double step) {
                 const double count = std::ceil(problem.duration / step);
                 return SoftWeb(problem, problem.duration / count).run();
             }}};
}

}  // namespace orbweaver::peers
