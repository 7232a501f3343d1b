#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "orbweaver/baked_file.hpp"
#include "orbweaver/fault.hpp"

namespace orbweaver {

/// What was baked from a source is in the cache, and is of no use.
class DamagedCache : public Fault {
public:
    DamagedCache(const std::string& source, const std::string& why);
};

/// Where what has that key belongs in cache_folder(): sources, recipe and versions are hashed into it.
std::string cached_path(const ContentHash& key);

/// What lies there, if anything does. Throws DamagedCache where it cannot be used; `source` stands for what it
/// was made from.
std::optional<BakedFile> open_cached(const std::string& path, std::string_view type, std::uint32_t version,
                                     const std::string& source);

/// What `open` opens, where a damaged file is as good as none, since it can be made again.
template <class Open>
std::optional<BakedFile> if_sound(const Open& open) {
    try {
        return open();
    } catch (const DamagedCache&) {
        return std::nullopt;
    }
}

/// Throws Fault(invalid) of a source that is not baked yet; `command` of orbweaver-assets bakes it alone.
[[noreturn]] void refuse_unbaked(const std::string& source, const char* command);

}  // namespace orbweaver
