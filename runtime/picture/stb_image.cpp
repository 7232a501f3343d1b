#include <cstddef>
#include <cstdlib>

namespace {

/// No picture within our limits needs a block as large as this; a compressed stream that claims to
/// unpacks without end.
constexpr std::size_t kLargestBlock = std::size_t{1} << 30;

void* allocate(std::size_t bytes) { return bytes > kLargestBlock ? nullptr : std::malloc(bytes); }
void* reallocate(void* block, std::size_t bytes) {
    return bytes > kLargestBlock ? nullptr : std::realloc(block, bytes);
}

}  // namespace

#define STBI_MALLOC(bytes) allocate(bytes)
#define STBI_REALLOC(block, bytes) reallocate(block, bytes)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_IMPLEMENTATION
#include "picture/stb_config.hpp"
