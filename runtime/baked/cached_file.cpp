#include "baked/cached_file.hpp"

#include <filesystem>

#include "baked/cache_folder.hpp"

namespace orbweaver {

DamagedCache::DamagedCache(const std::string& source, const std::string& why)
    : Fault(FaultKind::invalid, source + ": was baked, but " + why +
                                    "; orbweaver-assets bake, with this scene, makes it anew in the cache") {}

std::string cached_path(const ContentHash& key) { return cache_folder() + "/" + to_string(key) + ".baked"; }

std::optional<BakedFile> open_cached(const std::string& path, std::string_view type, std::uint32_t version,
                                     const std::string& source) {
    if (std::error_code ignored; !std::filesystem::exists(path, ignored)) return std::nullopt;
    try {
        return BakedFile(path, type, version);
    } catch (const Fault& fault) {
        throw DamagedCache(source, "what is kept of it cannot be used (" + std::string(fault.what()) + ")");
    }
}

void refuse_unbaked(const std::string& source, const char* command) {
    throw Fault(FaultKind::invalid,
                source +
                    ": is not baked yet; run orbweaver-assets bake with this scene, or bake it with "
                    "orbweaver-assets " +
                    command + " and name the baked file");
}

}  // namespace orbweaver
