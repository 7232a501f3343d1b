#include "spring_system.hpp"

#include <algorithm>

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
      pull_(3 * table_.slots),
      driven_(still_path()),
      drives_(network.driven ? table_.quads.size() / kGrain + 1 : 0) {}

void SpringSystem::network_changed() {
    std::vector<Vec3> external(external_.empty() ? 0 : size());
    if (!external.empty()) packing().unpack(external_, external);
    table_ = SpringTable(*network_);
    if (!external.empty()) packing().pack(external, external_);
    pull_.assign(3 * table_.slots, 0.0);
    driven_ = still_path();
    has_pulls_ = false;
    drives_.resize(network_->driven ? table_.quads.size() / kGrain + 1 : 0);
    creep_.clear();
    implicit_ = nullptr;
    spectral_bound_.reset();
}

void SpringSystem::put_on_arms(std::span<const Vec3> x) {
    if (!has_arms(*network_)) return;
    creep_.assign(table_.quads.size() * Packing::kLanes, 0.0);
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        creep_[table_.place[i]] = distance(x[s.a], x[s.b]) - rest_length(i);
    }
}

std::size_t SpringSystem::creep_count() const noexcept { return creep_.empty() ? 0 : table_.place.size(); }

void SpringSystem::get_creep(std::span<double> creep) const noexcept {
    for (std::size_t i = 0; i < creep.size(); ++i) creep[i] = creep_[table_.place[i]];
}

void SpringSystem::set_creep(std::span<const double> creep) noexcept {
    for (std::size_t i = 0; i < creep.size(); ++i) creep_[table_.place[i]] = creep[i];
}

std::span<double> SpringSystem::hook_forces() {
    external_.resize(length());
    return external_;
}

void SpringSystem::begin_frame(std::span<const double> creep) noexcept {
    set_creep(creep);
    if (hooks_ != nullptr) hooks_->rewind();
}

void SpringSystem::creep(std::span<const double> x, double h) noexcept {
    kernels_->creep(table_, x.data(), h, 0, table_.quads.size(), creep_.data());
}

// Springs of a driven network keep the lengths that it gives them, until they are told others.
std::vector<DrivenQuad> SpringSystem::still_path() const {
    std::vector<DrivenQuad> path(network_->driven ? table_.quads.size() : 0);
    for (std::size_t i = 0; i < path.size(); ++i) path[i].begin = path[i].end = table_.quads[i].rest_length;
    return path;
}

void SpringSystem::begin_rest_path(std::span<const double> x, std::span<const double> v) noexcept {
    const KernelInput input = kernel_input(x.data(), v.data());
    share_quads([&](std::size_t begin, std::size_t end) {
        kernels_->remember(table_, driven_.data(), input, begin, end);
        for (std::size_t i = begin; i < end; ++i) table_.quads[i].rest_length = driven_[i].begin;
    });
    has_pulls_ = false;
}

DriveWork SpringSystem::drive(std::span<const double> x, std::span<const double> v, double share,
                              double lag) noexcept {
    const KernelInput input = kernel_input(x.data(), v.data());
    auto range = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            drives_[i] = kernels_->drive(table_, driven_.data(), share, lag, input, i * kGrain,
                                         std::min((i + 1) * kGrain, table_.quads.size()), pull_.data());
    };
    if (workers_ == nullptr)
        range(0, drives_.size());
    else
        workers_->for_each_range(drives_.size(), 1, range);
    has_pulls_ = true;
    DriveWork all;
    for (const DriveWork& each : drives_) {
        all.work += each.work;
        all.damping += each.damping;
    }
    return all;
}

Tension SpringSystem::tension(std::size_t spring, double length) const noexcept {
    const Spring& s = network_->springs[spring];
    const double extension = length - rest_length(spring);
    Tension tension = tension_at(s, extension);
    if (creep_.empty()) return tension;
    tension.force += s.law.arm * (extension - creep_[table_.place[spring]]);
    tension.slope += s.law.arm;
    return tension;
}

void SpringSystem::set_surroundings(const Surroundings& surroundings) {
    gravity_ = surroundings.gravity;
    if (drag_ != surroundings.drag) spectral_bound_.reset();
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
           (external_.capacity() + pull_.capacity() + creep_.capacity()) * sizeof(double) +
           driven_.capacity() * sizeof(DrivenQuad);
}

KernelInput SpringSystem::kernel_input(const double* x, const double* v) const noexcept {
    return {x,
            v,
            external_.empty() ? nullptr : external_.data(),
            creep_.empty() ? nullptr : creep_.data(),
            gravity_,
            drag_};
}

template <class Pass>
void SpringSystem::share_quads(Pass pass) noexcept {
    if (workers_ == nullptr)
        pass(0, table_.quads.size());
    else
        workers_->for_each_range(table_.quads.size(), kGrain, pass);
}

void SpringSystem::find_pulls(const KernelInput& input) noexcept {
    share_quads(
        [&](std::size_t begin, std::size_t end) { kernels_->pulls(table_, input, begin, end, pull_.data()); });
}

template <class SecondPass>
void SpringSystem::use_pulls(SecondPass second_pass) noexcept {
    work_ += evaluation_seconds();
    has_pulls_ = false;
    if (workers_ == nullptr)
        second_pass(0, table_.blocks.size());
    else
        workers_->for_each_range(table_.blocks.size(), kGrain, second_pass);
}

void SpringSystem::accelerations(std::span<const double> x, std::span<const double> v,
                                 std::span<double> a) noexcept {
    has_pulls_ = false;
    accelerations_at_start(x, v, a);
}

void SpringSystem::accelerations_at_start(std::span<const double> x, std::span<const double> v,
                                          std::span<double> a) noexcept {
    const KernelInput input = kernel_input(x.data(), v.data());
    if (!has_pulls_) find_pulls(input);
    use_pulls([&](std::size_t begin, std::size_t end) {
        kernels_->accelerations(table_, input, pull_.data(), begin, end, a.data());
    });
}

void SpringSystem::kick_and_drift(std::span<double> x, std::span<double> v, double kick,
                                  double drift) noexcept {
    const KernelInput input = kernel_input(x.data(), nullptr);
    const KickAndDrift move{x.data(), v.data(), kick, drift};
    find_pulls(input);
    use_pulls([&](std::size_t begin, std::size_t end) {
        kernels_->kicks(table_, input, pull_.data(), move, begin, end);
    });
}

void SpringSystem::use_linear_solver(LinearSolverKind kind) {
    linear_solver_ = kind;
    implicit_.reset();
}

const SpectralBound& SpringSystem::spectral_bound() const {
    if (!spectral_bound_) spectral_bound_ = bound_spectrum(*network_, drag_);
    return *spectral_bound_;
}

bool SpringSystem::prepare(std::span<const double> x, double c, double k, Tangent tangent) {
    if (implicit_ == nullptr)
        implicit_ = std::make_unique<ImplicitTangent>(*network_, packing(), linear_solver_);
    work_ += implicit_->prepare_seconds();
    return implicit_->prepare(*this, x, c, k, tangent == Tangent::clamped);
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
    for (std::size_t i = 0; i < size(); ++i) {
        const std::size_t x = packing().place(i), y = plane + x, z = plane + y;
        sum += network_->mass[i] * (r[x] * u[x] + r[y] * u[y] + r[z] * u[z]);
    }
    return sum;
}

void SpringSystem::forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> f) const noexcept {
    for (std::size_t i = 0; i < size(); ++i) {
        f[i] = network_->mass[i] * gravity_ - drag_ * v[i] + external_force(i);
    }
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        const Vec3 l = x[s.a] - x[s.b];
        const double length = norm(l);
        const Vec3 pull = l * pull_factor(l, length, v[s.a] - v[s.b], tension(i, length).force, s.damping);
        f[s.a] -= pull;
        f[s.b] += pull;
    }
}

Vec3 SpringSystem::external_force(std::size_t particle) const noexcept {
    if (external_.empty()) return {};
    const std::size_t plane = packing().plane();
    const std::size_t at = packing().place(particle);
    return {external_[at], external_[plane + at], external_[2 * plane + at]};
}

Energy SpringSystem::energy(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept {
    Energy energy;
    for (std::size_t i = 0; i < size(); ++i) {
        energy.kinetic += 0.5 * network_->mass[i] * dot(v[i], v[i]);
        energy.potential -= network_->mass[i] * dot(gravity_, x[i]);
    }
    for (std::size_t i = 0; i < network_->springs.size(); ++i) {
        const Spring& s = network_->springs[i];
        const double extension = distance(x[s.a], x[s.b]) - rest_length(i);
        energy.elastic += elastic_energy(s, extension);
        if (creep_.empty()) continue;
        const double of_arm = extension - creep_[table_.place[i]];
        energy.elastic += 0.5 * s.law.arm * of_arm * of_arm;
    }
    return energy;
}

double tension(const Spring& spring, std::span<const Vec3> x) noexcept {
    return tension_at(spring, distance(x[spring.a], x[spring.b]) - spring.rest_length).force;
}

}  // namespace orbweaver::mass_spring
