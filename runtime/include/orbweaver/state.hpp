#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// What an array of a module's state means; goes into trajectory.json.
struct ArrayInfo {
    std::string unit;  ///< SI, "1" for none
    std::string meaning;
    bool record = true;  ///< whether --trajectory writes it
};

/// One module instance's block of everything that changes over time. The host owns the memory: it
/// hashes it, saves it in snapshots and restores it. An array's address and size stay as they are
/// from its making to the end of the run. Made during attach(), filled with zeros.
class StateStore {
public:
    virtual std::span<Vec3> vectors(std::string_view name, std::size_t count, ArrayInfo info) = 0;
    virtual std::span<double> scalars(std::string_view name, std::size_t count, ArrayInfo info) = 0;
    virtual std::span<std::uint64_t> words(std::string_view name, std::size_t count, ArrayInfo info) = 0;

protected:
    ~StateStore() = default;
};

}  // namespace orbweaver
