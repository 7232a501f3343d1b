#pragma once

#include <string_view>
#include <vector>

#include "orbweaver/contracts/inscriber.hpp"

namespace orbweaver::inscription {

/// The threads of one kind ("spiral", "radius"), in the web's order.
std::vector<std::uint32_t> threads_of(const WebAtRest& web, std::string_view kind);

/// The point of its radius that comes next away from the hub, of each point; itself where none does.
std::vector<std::uint32_t> next_outward(const WebAtRest& web);

}  // namespace orbweaver::inscription
