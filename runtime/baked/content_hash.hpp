#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "orbweaver/baked_file.hpp"

namespace orbweaver {

/// Hashes what it is fed, piece by piece.
class ContentHasher {
public:
    ContentHasher();
    ~ContentHasher();
    void add(const void* data, std::size_t size);
    /// A text and its length, so that texts in a row cannot be confused with others.
    void add(std::string_view text);
    ContentHash finish() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Of a whole file. Throws Fault(invalid) for one that cannot be read.
ContentHash hash_file(const std::string& path);

}  // namespace orbweaver
