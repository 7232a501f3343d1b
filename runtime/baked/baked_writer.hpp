#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "orbweaver/baked_file.hpp"

namespace orbweaver {

/// Gathers sections and writes them as one baked file. The same sections give the same bytes.
class BakedWriter {
public:
    /// `type` has at most 8 characters.
    BakedWriter(std::string_view type, std::uint32_t version, const ContentHash& source);

    /// Names have at most 16 characters. The records are not copied: they outlive the writer.
    template <class T>
    void add(std::string_view name, std::span<const T> records) {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);
        add(name, std::as_bytes(records), sizeof(T));
    }
    void add(std::string_view name, std::span<const std::byte> bytes, std::size_t stride);

    /// Throws Fault as AtomicFile does.
    void write(const std::string& path) const;

private:
    struct Section {
        std::string name;
        std::span<const std::byte> bytes;
        std::size_t stride;
    };

    std::string type_;
    std::uint32_t version_;
    ContentHash source_;
    std::vector<Section> sections_;
};

}  // namespace orbweaver
