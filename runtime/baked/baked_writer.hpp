#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
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
        sections_.push_back({std::string(name), std::as_bytes(records), sizeof(T), nullptr});
    }
    /// A section of one record, which is copied.
    template <class T>
    void add_record(std::string_view name, const T& record) {
        static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 64);
        const auto bytes = std::as_bytes(std::span(&record, 1));
        auto copy = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
        sections_.push_back({std::string(name), *copy, sizeof(T), copy});
    }

    /// Throws Fault as AtomicFile does.
    void write(const std::string& path) const;

private:
    struct Section {
        std::string name;
        std::span<const std::byte> bytes;
        std::size_t stride;
        std::shared_ptr<const std::vector<std::byte>> copy;  ///< what `bytes` are, where they are ours
    };

    std::string type_;
    std::uint32_t version_;
    ContentHash source_;
    std::vector<Section> sections_;
};

}  // namespace orbweaver
