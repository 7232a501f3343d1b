#include "spring_kernel.hpp"

#include "spring_force.hpp"

namespace orbweaver::mass_spring {
namespace {

void plain_pulls(const SpringTable& table, const KernelInput& input, std::size_t begin, std::size_t end,
                 PaddedVec3* pull) noexcept {
    for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t a = table.a[i];
        const std::uint32_t b = table.b[i];
        const Vec3 l = input.x[a] - input.x[b];
        const Vec3 dl = input.v[a] - input.v[b];
        const Vec3 f = l * pull_factor(l, dl, table.rest_length[i], table.stiffness[i], table.damping[i]);
        pull[2 * i] = {f.x, f.y, f.z, 0};
        pull[2 * i + 1] = {-f.x, -f.y, -f.z, 0};
    }
}

void plain_accelerations(const SpringTable& table, const KernelInput& input, const PaddedVec3* pull,
                         std::size_t begin, std::size_t end, Vec3* a) noexcept {
    for (std::size_t i = begin; i < end; ++i) {
        if (table.inverse_mass[i] == 0) {
            a[i] = {};
            continue;
        }
        Vec3 sum;
        for (std::uint32_t e = table.first[i]; e < table.first[i + 1]; ++e) {
            const PaddedVec3& f = pull[table.incident[e]];
            sum += Vec3{f.x, f.y, f.z};
        }
        if (input.external != nullptr) sum += input.external[i];
        sum -= input.drag * input.v[i];
        a[i] = sum * table.inverse_mass[i] + input.gravity;
    }
}

}  // namespace

SpringTable::SpringTable(const Network& network) : first(network.size() + 1), inverse_mass(network.size()) {
    for (const Spring& spring : network.springs) {
        a.push_back(spring.a);
        b.push_back(spring.b);
        rest_length.push_back(spring.rest_length);
        stiffness.push_back(spring.stiffness);
        damping.push_back(spring.damping);
        damped = damped || spring.damping > 0;
        ++first[spring.a + 1];
        ++first[spring.b + 1];
    }
    for (std::size_t i = 0; i < network.size(); ++i) {
        const std::uint32_t padded = (first[i + 1] + kGroup - 1) / kGroup * kGroup;
        first[i + 1] = first[i] + padded;
        inverse_mass[i] = network.fixed[i] != 0 ? 0 : 1 / network.mass[i];
    }
    incident.assign(first.back(), static_cast<std::uint32_t>(2 * springs()));
    std::vector<std::uint32_t> next = first;
    for (std::uint32_t i = 0; i < springs(); ++i) {
        incident[next[a[i]]++] = 2 * i + 1;
        incident[next[b[i]]++] = 2 * i;
    }
}

std::size_t SpringTable::memory_bytes() const noexcept {
    return (a.capacity() + b.capacity() + first.capacity() + incident.capacity()) * sizeof(std::uint32_t) +
           (rest_length.capacity() + stiffness.capacity() + damping.capacity() + inverse_mass.capacity()) *
               sizeof(double);
}

const SpringKernels& plain_kernels() noexcept {
    static constexpr SpringKernels kernels{plain_pulls, plain_accelerations};
    return kernels;
}

const SpringKernels& best_kernels() noexcept {
    const SpringKernels* avx2 = avx2_kernels();
    return avx2 != nullptr ? *avx2 : plain_kernels();
}

}  // namespace orbweaver::mass_spring
