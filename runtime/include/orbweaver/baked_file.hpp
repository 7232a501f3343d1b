#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace orbweaver {

/// XXH3 of 128 bits over what an asset was made from.
struct ContentHash {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    friend bool operator==(const ContentHash&, const ContentHash&) = default;
};

/// 32 hexadecimal digits.
std::string to_string(const ContentHash& hash);

/// A file that `orbweaver-assets` made, mapped read-only: sections of records, each aligned to 64 bytes, behind
/// a header with type, versions, byte order, the hash of its source and a checksum of everything.
/// modules/mesh/README.md draws the layout.
class BakedFile {
public:
    struct Section {
        std::string name;
        std::size_t offset = 0;  ///< bytes from the beginning of the file
        std::size_t count = 0;   ///< records
        std::size_t stride = 0;  ///< bytes a record
    };

    /// Maps and checks the whole file, checksum included. Throws Fault(invalid) with a sentence for a file that
    /// is not there, not ours, of another type, byte order or version, truncated, too long, or damaged.
    BakedFile(const std::string& path, std::string_view type, std::uint32_t version);
    BakedFile(BakedFile&& other) noexcept;
    BakedFile& operator=(BakedFile&& other) noexcept;
    ~BakedFile();

    /// The records of a section, valid while the file lives. Throws Fault(invalid) when it is missing, or its
    /// records are not of T's size.
    template <class T>
    std::span<const T> section(std::string_view name) const {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);
        const Section& found = find(name, sizeof(T));
        return {reinterpret_cast<const T*>(bytes_.data() + found.offset), found.count};
    }
    bool has(std::string_view name) const noexcept;

    const std::string& path() const noexcept { return path_; }
    const ContentHash& source_hash() const noexcept { return source_hash_; }
    const std::vector<Section>& sections() const noexcept { return sections_; }
    std::size_t size() const noexcept { return bytes_.size(); }

private:
    const Section& find(std::string_view name, std::size_t stride) const;
    void read_header(std::string_view type, std::uint32_t version);
    void read_sections(std::size_t count);
    [[noreturn]] void refuse(const std::string& what) const;

    std::string path_;
    std::span<const std::byte> bytes_;
    ContentHash source_hash_;
    std::vector<Section> sections_;
};

/// Whether a file begins as baked files do; false for one that cannot be read.
bool is_baked_file(const std::string& path) noexcept;

}  // namespace orbweaver
