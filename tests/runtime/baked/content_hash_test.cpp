#include "baked/content_hash.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

// Test vectors of xxHash itself: XXH3_128bits of nothing, and `xxhsum -H2` of "abc".
TEST_CASE("content is hashed by XXH3 of 128 bits", "[unit]") {
    const test::Folder folder;
    CHECK(to_string(hash_file(folder.write("empty", ""))) == "99aa06d3014798d86001c324468d497f");
    CHECK(to_string(hash_file(folder.write("abc", "abc"))) == "06b05ab6733a618578af5f94892f3950");
}

TEST_CASE("a file is hashed as the same bytes fed in pieces are", "[unit]") {
    const test::Folder folder;
    std::string bytes(200'001, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
    ContentHasher hasher;
    hasher.add(bytes.data(), 77);
    hasher.add(bytes.data() + 77, bytes.size() - 77);
    CHECK(hasher.finish() == hash_file(folder.write("f", bytes)));
}

TEST_CASE("texts in a row are told apart from others that run together alike", "[unit]") {
    ContentHasher one, other;
    for (const char* text : {"ab", "c"}) one.add(text);
    for (const char* text : {"a", "bc"}) other.add(text);
    CHECK_FALSE(one.finish() == other.finish());
}

TEST_CASE("a source that cannot be read is said", "[unit]") {
    const test::Folder folder;
    CHECK_THROWS_WITH(
        hash_file(folder.path("none")),
        folder.path("none") + ": cannot be read: No such file or directory; name a file that can");
    CHECK_THROWS_AS(hash_file(folder.path()), Fault);
}
