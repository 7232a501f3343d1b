#include "mesh_cache.hpp"

#include <filesystem>

#include "baked/cached_file.hpp"
#include "baked/content_hash.hpp"
#include "mesh_file.hpp"

namespace orbweaver::mesh {

namespace {

namespace fs = std::filesystem;

ContentHash key_of(const std::string& source, const Recipe& recipe) {
    ContentHasher key;
    const ContentHash content = hash_file(source);
    key.add(&content, sizeof content);
    for (const std::uint32_t version : {kMeshVersion, kBuilderVersion}) key.add(&version, sizeof version);
    key.add(&recipe.weld_tolerance, sizeof recipe.weld_tolerance);
    for (const auto& [material, property] : recipe.properties) {
        key.add(material);
        key.add(&property, sizeof property);
    }
    return key.finish();
}

/// The next text of a row of texts that are each ended by a zero.
std::string_view take_text(std::string_view& rest) {
    const std::string_view text = rest.substr(0, rest.find('\0'));
    rest.remove_prefix(std::min(rest.size(), text.size() + 1));
    return text;
}

bool is_as_it_was(const fs::path& path, std::string_view hash) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored) && to_string(hash_file(path.string())) == hash;
}

bool companions_are_as_they_were(const BakedFile& file, const std::string& source) {
    const auto section = file.section<char>("companions");
    const fs::path folder = fs::path(source).parent_path();
    for (std::string_view rest(section.data(), section.size()); !rest.empty();) {
        const fs::path path = folder / take_text(rest);
        if (!is_as_it_was(path, take_text(rest))) return false;
    }
    return true;
}

/// What was baked from this source, if it is there. Throws DamagedCache where it cannot be used.
std::optional<BakedFile> sound_cached(const std::string& source, const Recipe& recipe) {
    auto file = open_cached(cached_path(source, recipe), kMeshType, kMeshVersion, source);
    if (file && !companions_are_as_they_were(*file, source))
        throw DamagedCache(source, "a file that belongs to it has changed since");
    return file;
}

}  // namespace

std::vector<char> to_section(std::span<const Companion> companions) {
    std::vector<char> section;
    for (const Companion& each : companions)
        for (const std::string& text : {each.path, to_string(each.hash)}) {
            section.insert(section.end(), text.begin(), text.end());
            section.push_back('\0');
        }
    return section;
}

std::string cached_path(const std::string& source, const Recipe& recipe) {
    return orbweaver::cached_path(key_of(source, recipe));
}

std::optional<BakedFile> find_cached(const std::string& source, const Recipe& recipe) {
    return if_sound([&] { return sound_cached(source, recipe); });
}

BakedFile open_mesh(const std::string& path) {
    if (is_baked_file(path)) return {path, kMeshType, kMeshVersion};
    if (auto file = sound_cached(path, {})) return std::move(*file);
    refuse_unbaked(path, "adjacency");
}

}  // namespace orbweaver::mesh
