#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace orbweaver::baked {

inline constexpr std::array<char, 8> kMagic = {'O', 'R', 'B', 'W', 'B', 'A', 'K', 'E'};
inline constexpr std::uint32_t kByteOrder = 0x01020304;
inline constexpr std::uint32_t kContainerVersion = 1;
inline constexpr std::size_t kAlignment = 64;
inline constexpr std::size_t kMostSections = 64;

/// The first 64 bytes of a baked file.
struct Header {
    std::array<char, 8> magic = kMagic;
    std::uint32_t byte_order = kByteOrder;
    std::uint32_t container_version = kContainerVersion;
    std::array<char, 8> type{};  ///< padded with zeros
    std::uint32_t type_version = 0;
    std::uint32_t section_count = 0;
    std::uint64_t file_size = 0;  ///< bytes
    std::uint64_t source_hash_high = 0;
    std::uint64_t source_hash_low = 0;
    std::uint64_t checksum = 0;  ///< see checksum()
};
static_assert(sizeof(Header) == 64);

/// One for each section, behind the header.
struct SectionEntry {
    std::array<char, 16> name{};  ///< padded with zeros
    std::uint64_t offset = 0;     ///< from the beginning of the file, a multiple of kAlignment
    std::uint64_t count = 0;      ///< records
    std::uint32_t stride = 0;     ///< bytes a record
    std::uint32_t reserved = 0;
};
static_assert(sizeof(SectionEntry) == 40);

constexpr std::size_t aligned(std::size_t offset) noexcept {
    return (offset + kAlignment - 1) / kAlignment * kAlignment;
}

/// XXH3-64 of a whole file with the header's checksum taken as zero; the file holds a header at least.
std::uint64_t checksum(std::span<const std::byte> file) noexcept;

}  // namespace orbweaver::baked
