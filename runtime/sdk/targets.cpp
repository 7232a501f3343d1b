#include "orbweaver/targets.hpp"

#include <cstdlib>

namespace orbweaver {

bool wide_vectors_allowed() noexcept {
    static const bool allowed = std::getenv("ORBWEAVER_PLAIN") == nullptr;
    return allowed;
}

}  // namespace orbweaver
