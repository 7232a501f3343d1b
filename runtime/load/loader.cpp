#include "load/loader.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace orbweaver {

namespace {

// The system's loader maps segments without asking whether the file reaches that far, and dies touching them.
bool has_every_segment(std::ifstream& file, const Elf64_Ehdr& header, std::uintmax_t size) {
    file.seekg(static_cast<std::streamoff>(header.e_phoff));
    for (int i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment;
        file.read(reinterpret_cast<char*>(&segment), sizeof segment);
        if (!file || segment.p_offset > size || segment.p_filesz > size - segment.p_offset) return false;
    }
    return true;
}

void require_shared_object(const Manifest& manifest) {
    std::error_code error;
    if (!std::filesystem::exists(manifest.library, error))
        throw LoadError(LoadFault::no_file,
                        fmt::format("module '{}': its library {} is not there; build it, or remove {}",
                                    manifest.id, manifest.library, manifest.path));
    std::array<char, sizeof(Elf64_Ehdr)> bytes{};
    std::ifstream file(manifest.library, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    Elf64_Ehdr header;
    std::memcpy(&header, bytes.data(), sizeof header);
    const bool complete = file.gcount() == static_cast<std::streamsize>(bytes.size());
    if (!complete || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 || header.e_type != ET_DYN)
        throw LoadError(LoadFault::not_a_library,
                        fmt::format("module '{}': {} is not a shared library; expected an ELF shared object; "
                                    "build the module again",
                                    manifest.id, manifest.library));
    const auto size = std::filesystem::file_size(manifest.library, error);
    if (!has_every_segment(file, header, size))
        throw LoadError(LoadFault::not_a_library,
                        fmt::format("module '{}': {} ends too early, after {} bytes; build the module again",
                                    manifest.id, manifest.library, size));
}

void require_abi(const Manifest& manifest, const ModuleDescriptor* descriptor) {
    const std::uint32_t version = descriptor != nullptr ? descriptor->abi_version : 0;
    if (version != kAbiVersion)
        throw LoadError(
            LoadFault::wrong_abi,
            fmt::format("module '{}': {} speaks ABI version {} and this program version {}; build the "
                        "module against this program's SDK",
                        manifest.id, manifest.library, version, kAbiVersion));
    if (std::strcmp(descriptor->build_stamp, kBuildStamp) != 0)
        throw LoadError(
            LoadFault::wrong_build,
            fmt::format("module '{}': {} was built with \"{}\" and this program with \"{}\"; build both "
                        "from the same headers with the same compiler",
                        manifest.id, manifest.library, descriptor->build_stamp, kBuildStamp));
}

void require_same_manifest(const Manifest& manifest, const char* built_with) {
    if (manifest.text == built_with) return;
    std::stringstream file(manifest.text);
    std::stringstream built(built_with);
    std::string file_line;
    std::string built_line;
    int line = 0;
    do {
        ++line;
        if (!std::getline(file, file_line)) file_line = "(its end)";
        if (!std::getline(built, built_line)) built_line = "(its end)";
    } while (file_line == built_line && file && built);
    throw LoadError(
        LoadFault::manifest_mismatch,
        fmt::format("module '{}': line {} of {} is `{}`, but the module was built with `{}`; build the "
                    "module again, or restore its manifest",
                    manifest.id, line, manifest.path, file_line, built_line));
}

}  // namespace

LoadedModule::LoadedModule(const Manifest& manifest) {
    require_shared_object(manifest);
    handle_ = ::dlopen(manifest.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr)
        throw LoadError(LoadFault::cannot_open,
                        fmt::format("module '{}': the system's loader refuses it: {}; install what is missing",
                                    manifest.id, ::dlerror()));
    try {
        const auto entry = reinterpret_cast<EntryFunction>(::dlsym(handle_, kEntryName));
        if (entry == nullptr)
            throw LoadError(
                LoadFault::no_entry,
                fmt::format("module '{}': {} has no entry point {}; end the module with ORBWEAVER_MODULE(...)",
                            manifest.id, manifest.library, kEntryName));
        descriptor_ = entry();
        require_abi(manifest, descriptor_);
        require_same_manifest(manifest, descriptor_->manifest);
    } catch (...) {
        ::dlclose(handle_);
        throw;
    }
}

LoadedModule::~LoadedModule() { ::dlclose(handle_); }

}  // namespace orbweaver
