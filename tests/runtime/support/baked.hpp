#pragma once

#include <cstring>
#include <functional>

#include "baked/layout.hpp"
#include "support/folder.hpp"

namespace orbweaver::test {

using BakedBytes = std::string;

template <class T>
T read_at(const BakedBytes& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}
template <class T>
void write_at(BakedBytes& bytes, std::size_t offset, const T& value) {
    std::memcpy(bytes.data() + offset, &value, sizeof value);
}

/// Gives what was tampered with a checksum that holds.
inline void seal(BakedBytes& bytes) {
    const std::uint64_t sum = baked::checksum(std::as_bytes(std::span(bytes)));
    write_at(bytes, offsetof(baked::Header, checksum), sum);
}

inline std::size_t entry_at(std::size_t section) {
    return sizeof(baked::Header) + section * sizeof(baked::SectionEntry);
}

}  // namespace orbweaver::test
