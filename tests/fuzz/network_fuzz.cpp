#include "orbweaver/fault.hpp"
#include "web/network_file.hpp"

using namespace orbweaver;

// A network is refused with a Fault or with faults, or is a sound one; anything else is a defect.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        Diagnostics faults;
        const auto web =
            web::parse_network({reinterpret_cast<const char*>(data), size}, "network.json", faults);
        if (web.has_value() != faults.empty()) std::abort();
        if (web && !mass_spring::validate(web->network, web->layout.positions).empty()) std::abort();
    } catch (const Fault&) {
    }
    return 0;
}
