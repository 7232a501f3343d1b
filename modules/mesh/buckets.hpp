#pragma once

#include <cstdint>
#include <vector>

namespace orbweaver::mesh {

/// Items 0 to n - 1 sorted by a small key, in linear time; items of one key keep their order.
struct Buckets {
    std::vector<std::uint32_t> first;  ///< keys + 1: where each key's items begin
    std::vector<std::uint32_t> items;
};

template <class Key>
Buckets sort_into_buckets(std::uint32_t items, std::uint32_t keys, Key&& key_of) {
    Buckets buckets{std::vector<std::uint32_t>(std::size_t{keys} + 1), std::vector<std::uint32_t>(items)};
    for (std::uint32_t i = 0; i < items; ++i) ++buckets.first[key_of(i) + 1];
    for (std::uint32_t k = 0; k < keys; ++k) buckets.first[k + 1] += buckets.first[k];
    std::vector<std::uint32_t> next(buckets.first.begin(), buckets.first.end() - 1);
    for (std::uint32_t i = 0; i < items; ++i) buckets.items[next[key_of(i)]++] = i;
    return buckets;
}

}  // namespace orbweaver::mesh
