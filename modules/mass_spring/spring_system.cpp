#include "spring_system.hpp"

#include "spring_force.hpp"

namespace orbweaver::mass_spring {
namespace {

// Below this many springs an evaluation is shorter than waking a second thread twice.
constexpr std::size_t kSpringsWorthSharing = 8192;
constexpr std::size_t kGrain = 2048;

}  // namespace

SpringSystem::SpringSystem(const Network& network, Workers* workers)
    : network_(&network),
      workers_(network.springs.size() >= kSpringsWorthSharing ? workers : nullptr),
      table_(network),
      kernels_(&best_kernels()),
      pull_(table_.slots()) {}

void SpringSystem::set_surroundings(const Surroundings& surroundings) noexcept { surroundings_ = surroundings; }
const Surroundings& SpringSystem::surroundings() const noexcept { return surroundings_; }
const Network& SpringSystem::network() const noexcept { return *network_; }
std::size_t SpringSystem::size() const noexcept { return network_->size(); }

std::size_t SpringSystem::memory_bytes() const noexcept {
    return table_.memory_bytes() + pull_.capacity() * sizeof(PaddedVec3);
}

void SpringSystem::accelerations(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> a) noexcept {
    const Vec3* external = surroundings_.external.empty() ? nullptr : surroundings_.external.data();
    const KernelInput input{x.data(), v.data(), external, surroundings_.gravity, surroundings_.drag};
    if (workers_ == nullptr) {
        kernels_->pulls(table_, input, 0, table_.springs(), pull_.data());
        kernels_->accelerations(table_, input, pull_.data(), 0, size(), a.data());
        return;
    }
    workers_->for_each_range(table_.springs(), kGrain, [&](std::size_t begin, std::size_t end) {
        kernels_->pulls(table_, input, begin, end, pull_.data());
    });
    workers_->for_each_range(size(), kGrain, [&](std::size_t begin, std::size_t end) {
        kernels_->accelerations(table_, input, pull_.data(), begin, end, a.data());
    });
}

void SpringSystem::forces(std::span<const Vec3> x, std::span<const Vec3> v, std::span<Vec3> f) const noexcept {
    for (std::size_t i = 0; i < size(); ++i) {
        f[i] = network_->mass[i] * surroundings_.gravity - surroundings_.drag * v[i];
        if (!surroundings_.external.empty()) f[i] += surroundings_.external[i];
    }
    for (const Spring& s : network_->springs) {
        const Vec3 l = x[s.a] - x[s.b];
        const Vec3 pull = l * pull_factor(l, v[s.a] - v[s.b], s.rest_length, s.stiffness, s.damping);
        f[s.a] -= pull;
        f[s.b] += pull;
    }
}

Energy SpringSystem::energy(std::span<const Vec3> x, std::span<const Vec3> v) const noexcept {
    Energy energy;
    for (std::size_t i = 0; i < size(); ++i) {
        energy.kinetic += 0.5 * network_->mass[i] * dot(v[i], v[i]);
        energy.potential -= network_->mass[i] * dot(surroundings_.gravity, x[i]);
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
