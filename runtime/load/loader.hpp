#pragma once

#include <memory>
#include <string>

#include "orbweaver/entry.hpp"
#include "plan/manifest.hpp"

namespace orbweaver {

/// What can go wrong between a planned module and its running code. Each has its own sentence.
enum class LoadFault : std::uint8_t {
    no_file,
    not_a_library,  ///< the file is no ELF shared object
    cannot_open,    ///< the system's loader refused: most often a missing library
    no_entry,
    wrong_abi,
    wrong_build,        ///< other SDK headers, or another compiler
    manifest_mismatch,  ///< the manifest beside it is not the one it was built with
    cannot_create,      ///< its constructor failed
};

class LoadError : public Fault {
public:
    LoadError(LoadFault fault, const std::string& sentence)
        : Fault(FaultKind::invalid, sentence), fault_(fault) {}
    LoadFault fault() const noexcept { return fault_; }

private:
    LoadFault fault_;
};

/// A module's shared object in this process, opened RTLD_LOCAL; closed when the last owner goes.
class LoadedModule {
public:
    /// Opens and checks it. Throws LoadError.
    explicit LoadedModule(const Manifest& manifest);
    ~LoadedModule();
    LoadedModule(const LoadedModule&) = delete;
    LoadedModule& operator=(const LoadedModule&) = delete;

    const ModuleDescriptor& descriptor() const noexcept { return *descriptor_; }

private:
    void* handle_ = nullptr;
    const ModuleDescriptor* descriptor_ = nullptr;
};

}  // namespace orbweaver
