#include "baked/content_hash.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "orbweaver/fault.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace orbweaver {

struct ContentHasher::State {
    XXH3_state_t xxh;
};

ContentHasher::ContentHasher() : state_(std::make_unique<State>()) { XXH3_128bits_reset(&state_->xxh); }
ContentHasher::~ContentHasher() = default;

void ContentHasher::add(const void* data, std::size_t size) { XXH3_128bits_update(&state_->xxh, data, size); }

void ContentHasher::add(std::string_view text) {
    const std::uint64_t size = text.size();
    add(&size, sizeof size);
    add(text.data(), text.size());
}

ContentHash ContentHasher::finish() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh);
    return {hash.high64, hash.low64};
}

ContentHash hash_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    ContentHasher hasher;
    std::array<char, 65536> piece{};
    while (file) {
        file.read(piece.data(), piece.size());
        hasher.add(piece.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof())
        throw Fault(FaultKind::invalid,
                    path + ": cannot be read: " + std::strerror(errno) + "; name a file that can");
    return hasher.finish();
}

}  // namespace orbweaver
