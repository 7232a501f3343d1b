#include "spring_system.hpp"

#include "spectral_bound.hpp"
#include "spring_force.hpp"

namespace orbweaver::mass_spring {
namespace {

// Below this many springs an evaluation is shorter than waking a second thread twice.
constexpr std::size_t kSpringsWorthSharing = 8192;
constexpr std::size_t kGrain = 512;  // quads or blocks

}  // namespace

SpringSystem::SpringSystem(const Network& network, Workers* workers)
    : network_(&network),
      workers_(network.springs.size() >= kSpringsWorthSharing ? workers : nullptr),
      table_(network),
      kernels_(&best_kernels()),
      pull_(3 * table_.slots) {}

void SpringSystem::network_changed() {
    table_ = SpringTable(*network_);
    pull_.assign(3 * table_.slots, 0.0);
    implicit_ = nullptr;
    spectral_radius_ = -1;
}

void SpringSystem::set_surroundings(const Surroundings& surroundings) {
    gravity_ = surroundings.gravity;
    if (drag_ != surroundings.drag) spectral_radius_ = -1;
    drag_ = surroundings.drag;
    external_.resize(surroundings.external.empty() ? 0 : length());
    if (!external_.empty()) packing().pack(surroundings.external, external_);
}

const Network& SpringSystem::network() const noexcept { return *network_; }
std::size_t SpringSystem::size() const noexcept { return network_->size(); }
const Packing& SpringSystem::packing() const noexcept { return table_.packing; }
std::size_t SpringSystem::length() const noexcept { return table_.packing.length(); }

std::size_t SpringSystem::memory_bytes() const noexcept {
    return table_.memory_bytes() + (implicit_ != nullptr ? implicit_->memory_bytes() : 0) +
           (external_.capacity() + pull_.capacity()) * sizeof(double);
}

void SpringSystem::accelerations(std::span<const double> x, std::span<const double> v,
                                 std::span<double> a) noexcept {
    work_ += evaluation_seconds();
    const KernelInput input{x.data(), v.data(), external_.empty() ? nullptr : external_.data(), gravity_,
                            drag_};
    auto pulls = [&](std::size_t begin, std::size_t end) {
        kernels_->pulls(table_, input, begin, end, pull_.data());
    };
    auto accelerate = [&](std::size_t begin, std::size_t end) {
        kernels_->accelerations(table_, input, pull_.data(), begin, end, a.data());
    };
    if (workers_ == nullptr) {
        pulls(0, table_.quads.size());
        accelerate(0, table_.blocks.size());
        return;
    }
    workers_->for_each_range(table_.quads.size(), kGrain, pulls);
    workers_->for_each_range(table_.blocks.size(), kGrain, accelerate);
}

void SpringSystem::use_linear_solver(LinearSolverKind kind) {
    linear_solver_ = kind;
    implicit_.reset();
}

double SpringSystem::spectral_radius() {
    if (spectral_radius_ < 0) spectral_radius_ = bound_spectrum(*network_, drag_).radius();
    return spectral_radius_;
}

bool SpringSystem::prepare(std::span<const double> x, double c, double k, Tangent tangent) {
    if (implicit_ == nullptr) implicit_ = std::make_unique<ImplicitTangent>(*network_, linear_solver_);
    work_ += implicit_->prepare_seconds();
    return implicit_->prepare(x, drag_, c, k, tangent == Tangent::clamped);
}

void SpringSystem::solve(std::span<const double> r, std::span<double> u) {
    implicit_->solve(r, u);
    work_ += implicit_->solve_seconds();
}

double SpringSystem::evaluation_seconds() const noexcept {
    constexpr double kSpring = 2.8e-9, kParticle = 2e-9;
    return kSpring * static_cast<double>(network_->springs.size()) + kParticle * static_cast<double>(size());
}

double SpringSystem::inner_product(std::span<const double> r, std::span<const double> u) const noexcept {
    const std::size_t plane = packing().plane();
    double sum = 0;
    for (std::size_t i = 0; i < size(); ++i)
        sum += network_->mass[i] *
               (r[i] * u[i] + r[plane + i] * u[plane + i] + r[2 * plane + i] * u[2 * plane + i]);
    return sum;
}

void SpringSystem::forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> f) const noexcept {
    for (std::size_t i = 0; i < size(); ++i) {
        f[i] = network_->mass[i] * gravity_ - drag_ * v[i] + external_force(i);
    }
    for (const Spring& s : network_->springs) {
        const Vec3 l = x[s.a] - x[s.b];
        const Vec3 pull = l * pull_factor(l, v[s.a] - v[s.b], s.rest_length, s.stiffness, s.damping);
        f[s.a] -= pull;
        f[s.b] += pull;
    }
}

Vec3 SpringSystem::external_force(std::size_t particle) const noexcept {
    if (external_.empty()) return {};
    const std::size_t plane = packing().plane();
    return {external_[particle], external_[plane + particle], external_[2 * plane + particle]};
}

Energy SpringSystem::energy(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept {
    Energy energy;
    for (std::size_t i = 0; i < size(); ++i) {
        energy.kinetic += 0.5 * network_->mass[i] * dot(v[i], v[i]);
        energy.potential -= network_->mass[i] * dot(gravity_, x[i]);
    }
    for (const Spring& s : network_->springs) {
        const double extension = distance(x[s.a], x[s.b]) - s.rest_length;
        energy.elastic += 0.5 * s.stiffness * extension * extension;
    }
    return energy;
}

double tension(const Spring& spring, std::span<const Vec3> x) noexcept {
    return spring.stiffness * (distance(x[spring.a], x[spring.b]) - spring.rest_length);
}

}  // namespace orbweaver::mass_spring
