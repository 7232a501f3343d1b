#include "baked/cache_folder.hpp"

#include <cstdlib>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

}  // namespace

std::string cache_folder() {
    if (std::string own = environment("ORBWEAVER_CACHE"); !own.empty()) return own;
    if (const std::string all = environment("XDG_CACHE_HOME"); !all.empty()) return all + "/orbweaver";
    if (const std::string home = environment("HOME"); !home.empty()) return home + "/.cache/orbweaver";
    throw Fault(FaultKind::invalid, "there is no folder for baked files; set ORBWEAVER_CACHE or HOME to one");
}

}  // namespace orbweaver
