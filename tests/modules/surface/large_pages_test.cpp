#include "large_pages.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <vector>

using namespace orbweaver::surface;

namespace {

struct alignas(32) Record {
    std::uint64_t number;
};

std::uintptr_t beyond(const void* place, std::size_t alignment) {
    return reinterpret_cast<std::uintptr_t>(place) % alignment;
}

}  // namespace

TEST_CASE("large arrays begin at a large page, small ones where their elements may", "[unit]") {
    std::vector<Record, LargePages<Record>> small(3), large(100'000);
    CHECK(beyond(small.data(), alignof(Record)) == 0);
    CHECK(beyond(large.data(), std::size_t{2} << 20) == 0);
}

TEST_CASE("an array keeps what is in it while it grows out of small pages into large ones", "[unit]") {
    std::vector<Record, LargePages<Record>> growing;
    for (std::uint64_t i = 0; i < 200'000; ++i) growing.push_back({i});
    std::uint64_t wrong = 0;
    for (std::uint64_t i = 0; i < growing.size(); ++i) wrong += growing[i].number != i;
    CHECK(wrong == 0);
}
