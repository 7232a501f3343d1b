#include <bit>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "orbweaver/targets.hpp"
#include "underfoot.hpp"
#include "walk_samples.hpp"

using namespace orbweaver;
using namespace orbweaver::surface;

namespace {

/// FNV-1a over the bits of an answer.
void add(std::uint64_t& hash, const SurfaceHit& hit) {
    const auto mix = [&](std::uint64_t bits) { hash = (hash ^ bits) * 0x100000001B3; };
    mix(static_cast<std::uint64_t>(hit.answer));
    mix(hit.at.face);
    for (const double each : {hit.distance, hit.at.weights[0], hit.at.weights[1], hit.at.weights[2]})
        mix(std::bit_cast<std::uint64_t>(each));
}

std::string hash_of_answers() {
    const test::WalkSamples s(ORBWEAVER_MESHES "/spot.obj");
    std::uint64_t hash = 0xCBF29CE484222325;
    for (const auto* rays : {&s.short_rays, &s.long_rays})
        for (const SurfaceRay& ray : *rays) add(hash, first_hit(*s.parts.tree(), s.set, ray));
    for (const Stance& stance : s.stances) add(hash, underfoot(s.mesh, s.parts, stance).hit);
    return std::to_string(hash);
}

}  // namespace

TEST_CASE("rays and walkers get the same bits with the widest vectors and without", "[unit]") {
    constexpr const char* kExpected = "ORBWEAVER_EXPECTED_ANSWERS";
    const std::string found = hash_of_answers();
    if (const char* expected = std::getenv(kExpected); expected != nullptr) {
        CHECK_FALSE(has_avx2());
        CHECK(found == expected);
        return;
    }
    const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string plain = std::string("ORBWEAVER_PLAIN=1 ") + kExpected + "=" + found + " '" + self +
                              "' 'rays and walkers*' -w NoTests > /dev/null";
    CHECK(std::system(plain.c_str()) == 0);
}
