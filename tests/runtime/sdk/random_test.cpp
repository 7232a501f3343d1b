#include "orbweaver/random.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

using namespace orbweaver;

TEST_CASE("the streams are SplitMix64 behind an FNV-1a key, number for number", "[unit]") {
    // From an implementation of its own, of Steele, Lea, Flood 2014 and the FNV page.
    struct Case {
        std::uint64_t seed;
        const char* name;
        std::array<std::uint64_t, 3> bits;  ///< numbers 0, 1 and 1000000
        double uniform;
    };
    const Case cases[] = {
        {0, "", {0x0d7293fe83b1a2bcULL, 0x764ede80904bee69ULL, 0xe63e722874334afcULL}, 0x1.ae527fd076340p-5},
        {7,
         "web/radii",
         {0xc33a43af72b6e54bULL, 0xd9bcecdaee43056aULL, 0x068c7e22284e28a6ULL},
         0x1.8674875ee56dcp-1},
        {std::numeric_limits<std::uint64_t>::max(),
         "wind/gust",
         {0x31a92763c3139dfeULL, 0x4f8f546c1fd100f4ULL, 0xe167d588faaa58e2ULL},
         0x1.8d493b1e189ccp-3},
    };
    for (const Case& c : cases) {
        CAPTURE(c.seed, c.name);
        const RandomStream stream(c.seed, c.name);
        CHECK(stream.bits(0) == c.bits[0]);
        CHECK(stream.bits(1) == c.bits[1]);
        CHECK(stream.bits(1000000) == c.bits[2]);
        CHECK(stream.uniform(0) == c.uniform);
    }
}

TEST_CASE("uniform numbers fill [0, 1) evenly", "[unit]") {
    const RandomStream stream(11, "even");
    constexpr int kNumbers = 100000;
    std::array<int, 100> bins{};
    double sum = 0;
    double squares = 0;
    for (std::uint64_t i = 0; i < kNumbers; ++i) {
        const double u = stream.uniform(i);
        REQUIRE(u >= 0);
        REQUIRE(u < 1);
        ++bins[static_cast<std::size_t>(u * 100)];
        sum += u;
        squares += u * u;
    }
    CHECK(sum / kNumbers == Approx(0.5).margin(5 / std::sqrt(12.0 * kNumbers)));  // five standard errors
    CHECK(squares / kNumbers == Approx(1.0 / 3).margin(0.005));
    double chi_square = 0;
    for (const int count : bins) chi_square += (count - 1000.0) * (count - 1000.0) / 1000;
    CHECK(chi_square < 99 + 5 * std::sqrt(2 * 99.0));  // 99 degrees of freedom, five deviations
    CHECK(chi_square > 99 - 5 * std::sqrt(2 * 99.0));
}

TEST_CASE("neighbouring numbers, names and seeds have nothing to do with each other", "[unit]") {
    const auto correlation = [](const RandomStream& a, const RandomStream& b, std::uint64_t shift) {
        constexpr std::uint64_t kNumbers = 20000;
        double sum = 0;
        for (std::uint64_t i = 0; i < kNumbers; ++i) sum += (a.uniform(i) - 0.5) * (b.uniform(i + shift) - 0.5);
        return 12 * sum / kNumbers;
    };
    const double bound = 5 / std::sqrt(20000.0);
    const RandomStream stream(1, "a");
    CHECK(std::abs(correlation(stream, stream, 1)) < bound);
    CHECK(std::abs(correlation(stream, {1, "b"}, 0)) < bound);
    CHECK(std::abs(correlation(stream, {2, "a"}, 0)) < bound);
    CHECK(correlation(stream, stream, 0) == Approx(1).margin(0.05));
}

TEST_CASE("other names and seeds give other numbers, the same ones the same", "[unit]") {
    std::set<std::uint64_t> firsts;
    for (const char* name : {"", "a", "b", "ab", "ba", "web/radii", "web.2/radii"})
        for (const std::uint64_t seed : {0, 1, 2}) firsts.insert(RandomStream(seed, name).bits(0));
    CHECK(firsts.size() == 21);
    CHECK(RandomStream(5, "same").bits(3) == RandomStream(5, "same").bits(3));
}

TEST_CASE("a stretched uniform number stays in its range", "[unit]") {
    const RandomStream stream(4, "range");
    for (std::uint64_t i = 0; i < 1000; ++i) {
        REQUIRE(stream.uniform(i, -3, 5) >= -3);
        REQUIRE(stream.uniform(i, -3, 5) < 5);
    }
    CHECK(stream.uniform(0, 2, 2) == 2);
}
