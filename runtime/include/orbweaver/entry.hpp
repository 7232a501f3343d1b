#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <new>
#include <string>

#include "orbweaver/build_stamp.hpp"
#include "orbweaver/module.hpp"

namespace orbweaver {

/// Raised whenever ModuleDescriptor itself changes; checked before anything else is read.
inline constexpr std::uint32_t kAbiVersion = 2;

/// Everything the host may call of a module. No exception leaves these functions: false (or null)
/// means that `fault` was filled in.
struct ModuleDescriptor {
    std::uint32_t abi_version;
    const char* build_stamp;  ///< of the SDK headers and the compiler it was built with
    const char* manifest;     ///< the text of the manifest it was built with
    Module* (*create)(FaultRecord& fault) noexcept;
    void (*destroy)(Module* module) noexcept;
    bool (*attach)(Module& module, Host& host, FaultRecord& fault) noexcept;
    bool (*meet)(Module& module, Host& host, FaultRecord& fault) noexcept;
    bool (*run)(Module& module, Phase phase, const Frame& frame, FaultRecord& fault) noexcept;
    bool (*restored)(Module& module, FaultRecord& fault) noexcept;
    bool (*finish)(Module& module, FaultRecord& fault) noexcept;
    bool (*report)(Module& module, ModuleReport& report, FaultRecord& fault) noexcept;
};

/// The one symbol that a module exports.
inline constexpr const char* kEntryName = "orbweaver_module";
using EntryFunction = const ModuleDescriptor* (*)() noexcept;

namespace entry {

template <class Call>
bool guarded(FaultRecord& fault, Call&& call) noexcept {
    try {
        call();
        return true;
    } catch (const Fault& e) {
        fault = {e.kind(), e.what()};
    } catch (const std::bad_alloc&) {
        fault = {FaultKind::limit, "out of memory; ask for less, or give the process more"};
    } catch (const std::exception& e) {
        fault = {FaultKind::internal, e.what()};
    } catch (...) {
        fault = {FaultKind::internal, "threw something that is not a std::exception"};
    }
    return false;
}

template <class M>
constexpr ModuleDescriptor describe(const char* manifest) noexcept {
    return {
        kAbiVersion,
        kBuildStamp,
        manifest,
        [](FaultRecord& fault) noexcept -> Module* {
            Module* made = nullptr;
            guarded(fault, [&] { made = std::make_unique<M>().release(); });
            return made;
        },
        [](Module* module) noexcept { delete module; },
        [](Module& module, Host& host, FaultRecord& fault) noexcept {
            return guarded(fault, [&] { module.attach(host); });
        },
        [](Module& module, Host& host, FaultRecord& fault) noexcept {
            return guarded(fault, [&] { module.meet(host); });
        },
        [](Module& module, Phase phase, const Frame& frame, FaultRecord& fault) noexcept {
            return guarded(fault, [&] { module.run(phase, frame); });
        },
        [](Module& module, FaultRecord& fault) noexcept { return guarded(fault, [&] { module.restored(); }); },
        [](Module& module, FaultRecord& fault) noexcept { return guarded(fault, [&] { module.finish(); }); },
        [](Module& module, ModuleReport& report, FaultRecord& fault) noexcept {
            return guarded(fault, [&] { module.report(report); });
        },
    };
}

}  // namespace entry
}  // namespace orbweaver

/// Put once into a module, at namespace scope, with `kManifest` from its generated manifest_text.hpp.
#define ORBWEAVER_MODULE(Type)                                                           \
    extern "C" __attribute__((visibility("default"))) const orbweaver::ModuleDescriptor* \
    orbweaver_module() noexcept {                                                        \
        static constexpr orbweaver::ModuleDescriptor descriptor =                        \
            orbweaver::entry::describe<Type>(orbweaver::kManifest);                      \
        return &descriptor;                                                              \
    }
