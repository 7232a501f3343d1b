#include "network.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "quantity.hpp"

namespace orbweaver::mass_spring {
namespace {

using Element = NetworkFault::Element;

void check_sizes(const Network& network, std::size_t positions, std::vector<NetworkFault>& faults) {
    const std::string particles = std::to_string(network.size());
    if (network.size() == 0) faults.push_back({Element::network, 0, "the network has no particles"});
    if (network.fixed.size() != network.size()) {
        faults.push_back({Element::network, 0,
                          "the network has " + particles + " masses but " +
                              std::to_string(network.fixed.size()) + " fixed flags; expected one of each"});
    }
    if (positions != network.size()) {
        faults.push_back({Element::network, 0,
                          "the network has " + particles + " masses but " + std::to_string(positions) +
                              " positions; expected one of each"});
    }
}

void check_particles(const Network& network, std::span<const Vec3> positions,
                     std::vector<NetworkFault>& faults) {
    for (std::size_t i = 0; i < network.size(); ++i) {
        const std::string name = "particle " + std::to_string(i);
        if (!std::isfinite(network.mass[i]) || network.mass[i] <= 0) {
            faults.push_back({Element::particle, i,
                              name + " has a mass of " + number_text(network.mass[i]) +
                                  " kg; expected a finite mass above 0"});
        }
        if (i < positions.size() && !is_finite(positions[i])) {
            faults.push_back({Element::particle, i,
                              name + " has a position that is not finite; expected three finite metres"});
        }
    }
}

void check_constant(double value, const char* what, const char* unit, std::size_t index,
                    std::vector<NetworkFault>& faults) {
    if (std::isfinite(value) && value >= 0) return;
    faults.push_back({Element::spring, index,
                      "spring " + std::to_string(index) + " has a " + what + " of " + number_text(value) + " " +
                          unit + "; expected a finite one of at least 0"});
}

void check_law(const MaterialLaw& law, std::size_t index, std::vector<NetworkFault>& faults) {
    check_constant(law.softening, "softening", "1/m", index, faults);
    check_constant(law.stiffening, "stiffening", "1/m^2", index, faults);
    check_constant(law.arm, "relaxing stiffness", "N/m", index, faults);
    const std::string name = "spring " + std::to_string(index);
    if (!law.rises())
        faults.push_back({Element::spring, index,
                          name + " softens by " + number_text(law.softening) + " 1/m and stiffens by " +
                              number_text(law.stiffening) +
                              " 1/m^2, so it would bear less when stretched more; expected a softening whose "
                              "square is below three times the stiffening"});
    if (law.arm > 0 && !(std::isfinite(law.relaxation_time) && law.relaxation_time > 0))
        faults.push_back({Element::spring, index,
                          name + " has a relaxation time of " + number_text(law.relaxation_time) +
                              " s; expected a finite one above 0"});
}

void check_ends(const Network& network, std::span<const Vec3> positions, std::size_t index,
                std::vector<NetworkFault>& faults) {
    const Spring& spring = network.springs[index];
    const std::string name = "spring " + std::to_string(index);
    bool in_range = true;
    for (const std::uint32_t end : {spring.a, spring.b}) {
        if (end < network.size()) continue;
        in_range = false;
        faults.push_back({Element::spring, index,
                          name + " ends at particle " + std::to_string(end) + "; expected an index below " +
                              std::to_string(network.size())});
    }
    if (spring.a == spring.b) {
        faults.push_back({Element::spring, index,
                          name + " joins particle " + std::to_string(spring.a) +
                              " to itself; expected two different particles"});
    } else if (in_range && spring.a < positions.size() && spring.b < positions.size() &&
               distance(positions[spring.a], positions[spring.b]) == 0) {
        faults.push_back({Element::spring, index,
                          name + " has no length: particles " + std::to_string(spring.a) + " and " +
                              std::to_string(spring.b) +
                              " are at the same point, so its direction is undefined; move one of them"});
    }
}

}  // namespace

bool is_curved(const Network& network) noexcept {
    return std::any_of(network.springs.begin(), network.springs.end(),
                       [](const Spring& spring) { return spring.law.is_curved(); });
}

bool has_arms(const Network& network) noexcept {
    return std::any_of(network.springs.begin(), network.springs.end(),
                       [](const Spring& spring) { return spring.law.arm > 0; });
}

bool is_damped(const Network& network) noexcept {
    return std::any_of(network.springs.begin(), network.springs.end(),
                       [](const Spring& spring) { return spring.damping > 0; });
}

std::vector<NetworkFault> validate(const Network& network, std::span<const Vec3> positions) {
    std::vector<NetworkFault> faults;
    check_sizes(network, positions.size(), faults);
    check_particles(network, positions, faults);
    for (std::size_t i = 0; i < network.springs.size(); ++i) {
        check_ends(network, positions, i, faults);
        check_constant(network.springs[i].rest_length, "rest length", "m", i, faults);
        check_constant(network.springs[i].stiffness, "stiffness", "N/m", i, faults);
        check_constant(network.springs[i].damping, "damping", "N s/m", i, faults);
        check_law(network.springs[i].law, i, faults);
    }
    return faults;
}

std::size_t count_parts(const Network& network) {
    std::vector<std::size_t> parent(network.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    std::size_t parts = network.size();
    for (const Spring& spring : network.springs) {
        const std::size_t a = root(spring.a);
        const std::size_t b = root(spring.b);
        if (a == b) continue;
        parent[b] = a;
        --parts;
    }
    return parts;
}

}  // namespace orbweaver::mass_spring
