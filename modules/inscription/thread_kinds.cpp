#include "thread_kinds.hpp"

namespace orbweaver::inscription {

std::vector<std::uint32_t> threads_of(const WebAtRest& web, std::string_view kind) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < web.segments.size(); ++i)
        if (web.kinds[web.segments[i].kind] == kind) found.push_back(i);
    return found;
}

}  // namespace orbweaver::inscription
