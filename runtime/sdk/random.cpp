#include "orbweaver/random.hpp"

namespace orbweaver {

namespace {

std::uint64_t mix(std::uint64_t z) noexcept {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name) noexcept {
    std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a: spelled out, since std::hash may differ
    for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    key_ = mix(mix(seed + 0x9e3779b97f4a7c15ULL) ^ hash);
}

std::uint64_t RandomStream::bits(std::uint64_t n) const noexcept {
    return mix(key_ + (n + 1) * 0x9e3779b97f4a7c15ULL);
}

double RandomStream::uniform(std::uint64_t n) const noexcept {
    return static_cast<double>(bits(n) >> 11) * 0x1.0p-53;
}

double RandomStream::uniform(std::uint64_t n, double low, double high) const noexcept {
    return low + (high - low) * uniform(n);
}

}  // namespace orbweaver
