#pragma once

#include <string>
#include <vector>

#include "orbweaver/fault.hpp"
#include "species.hpp"

namespace orbweaver::spider::test {

/// The legs of a species that we ship.
inline std::vector<Leg> species_legs(const std::string& name) {
    Diagnostics faults;
    const auto read = read_species_file(ORBWEAVER_SOURCE_DIR "/assets/creatures/" + name + ".toml", faults);
    if (!read) throw Fault(FaultKind::invalid, to_string(faults.front()));
    std::vector<Leg> legs;
    for (const Limb& limb : read->limbs) legs.push_back(limb.leg);
    return legs;
}

}  // namespace orbweaver::spider::test
