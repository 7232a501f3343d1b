#include "orbweaver/baked_file.hpp"

#include <catch2/catch.hpp>
#include <functional>
#include <optional>

#include "baked/baked_writer.hpp"
#include "orbweaver/fault.hpp"
#include "support/baked.hpp"

using namespace orbweaver;
using namespace orbweaver::baked;
using test::BakedBytes;
using test::write_at;

namespace {

const std::vector<double> kNumbers = {1.5, -2, 1e300};
const std::vector<std::uint32_t> kIndices = {7, 8, 9, 10, 11};

/// A sound file of two sections, as bytes.
BakedBytes sample() {
    const test::Folder folder;
    BakedWriter writer("sample", 3, {1, 2});
    writer.add("numbers", std::span(kNumbers));
    writer.add("indices", std::span(kIndices));
    writer.write(folder.path("f"));
    return test::read_file(folder.path("f"));
}

/// The sentence that a file is refused with, behind its name; nothing when it is not.
std::string refusal(const BakedBytes& bytes) {
    const test::Folder folder;
    const std::string path = folder.write("f", bytes);
    try {
        const BakedFile file(path, "sample", 3);
        file.section<double>("numbers");
        file.section<std::uint32_t>("indices");
    } catch (const Fault& fault) {
        CHECK(fault.kind() == FaultKind::invalid);
        return std::string(fault.what()).substr(path.size() + 2);
    }
    return "";
}

struct Case {
    const char* sentence;
    std::function<void(BakedBytes&)> spoil;
};

void check_refusals(const std::vector<Case>& cases, bool sealed) {
    for (const Case& each : cases) {
        BakedBytes bytes = sample();
        each.spoil(bytes);
        if (sealed) test::seal(bytes);
        CHECK(refusal(bytes) == each.sentence);
    }
}

const std::string kAgain = "; bake it again with orbweaver-assets";

}  // namespace

TEST_CASE("a baked file gives back what was written, aligned to 64 bytes", "[unit]") {
    const test::Folder folder;
    const BakedFile file(folder.write("f", sample()), "sample", 3);
    const auto numbers = file.section<double>("numbers");
    const auto indices = file.section<std::uint32_t>("indices");
    CHECK(std::vector<double>(numbers.begin(), numbers.end()) == kNumbers);
    CHECK(std::vector<std::uint32_t>(indices.begin(), indices.end()) == kIndices);
    CHECK(reinterpret_cast<std::uintptr_t>(numbers.data()) % 64 == 0);
    CHECK(reinterpret_cast<std::uintptr_t>(indices.data()) % 64 == 0);
    CHECK(file.source_hash() == ContentHash{1, 2});
    CHECK(file.has("numbers"));
    CHECK_FALSE(file.has("nodes"));
}

TEST_CASE("a file outlives the object it was moved from", "[unit]") {
    const test::Folder folder;
    std::optional<BakedFile> first(std::in_place, folder.write("f", sample()), "sample", 3);
    BakedFile second(std::move(*first));
    first.reset();
    CHECK(second.section<double>("numbers")[0] == 1.5);
    BakedFile third(folder.path("f"), "sample", 3);
    third = std::move(second);
    CHECK(third.section<double>("numbers")[2] == 1e300);
}

TEST_CASE("a file that is not there, or no file, is refused in words", "[unit]") {
    const test::Folder folder;
    const std::string remedy = "; name a file that orbweaver-assets baked";
    CHECK_THROWS_WITH(BakedFile(folder.path("none"), "sample", 3),
                      folder.path("none") + ": cannot be read: No such file or directory" + remedy);
    CHECK_THROWS_WITH(BakedFile(folder.path(), "sample", 3),
                      folder.path() + ": cannot be read: it is a folder" + remedy);
}

TEST_CASE("foreign, superseded, cut and damaged files are refused in words", "[unit]") {
    check_refusals(
        {{"is not a baked file; expected one that orbweaver-assets made", [](BakedBytes& b) { b.clear(); }},
         {"is not a baked file; expected one that orbweaver-assets made",
          [](BakedBytes& b) { b = "v 1 2 3\n"; }},
         {"is not a baked file; expected one that orbweaver-assets made", [](BakedBytes& b) { b.resize(7); }},
         {"is truncated: it has 63 bytes, less than a header; bake it again with orbweaver-assets",
          [](BakedBytes& b) { b.resize(63); }},
         {"was baked on a machine of the other byte order; bake it again on this one",
          [](BakedBytes& b) { write_at(b, 8, 0x04030201u); }},
         {"is damaged: its mark of byte order means nothing; bake it again with orbweaver-assets",
          [](BakedBytes& b) { write_at(b, 8, 0u); }},
         {"is a baked file of version 0; expected 1, so bake it again with orbweaver-assets",
          [](BakedBytes& b) { write_at(b, 12, 0u); }},
         {"is a baked file of version 2; expected 1, so update Orbweaver or bake it again with this one's "
          "orbweaver-assets",
          [](BakedBytes& b) { write_at(b, 12, 2u); }},
         {"holds a simple; expected a sample", [](BakedBytes& b) { b.replace(16, 6, "simple"); }},
         {"holds a ?ample; expected a sample", [](BakedBytes& b) { b[16] = '\n'; }},
         {"holds a sample of version 2; expected 3, so bake it again with orbweaver-assets",
          [](BakedBytes& b) { write_at(b, 24, 2u); }},
         {"holds a sample of version 4; expected 3, so update Orbweaver or bake it again with this one's "
          "orbweaver-assets",
          [](BakedBytes& b) { write_at(b, 24, 4u); }},
         {"is truncated: it has 275 of 276 bytes; bake it again with orbweaver-assets",
          [](BakedBytes& b) { b.pop_back(); }},
         {"is too long: it has 277 of 276 bytes; bake it again with orbweaver-assets",
          [](BakedBytes& b) { b.push_back('\0'); }}},
        false);
}

TEST_CASE("one flipped bit anywhere behind the header's texts is noticed", "[unit]") {
    const BakedBytes sound = sample();
    REQUIRE(refusal(sound).empty());
    for (std::size_t bit = 8 * 28; bit < 8 * sound.size(); ++bit) {
        BakedBytes bytes = sound;
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
        const std::string sentence = refusal(bytes);
        if (sentence == "is damaged: its checksum is wrong" + kAgain) continue;
        REQUIRE(bit >= 8 * 32);  // the size has a sentence of its own
        REQUIRE(bit < 8 * 40);
        REQUIRE(sentence.starts_with("is t"));  // truncated, too long
    }
}

TEST_CASE("a file whose checksum holds but whose sections do not is refused in words", "[unit]") {
    const std::size_t numbers = test::entry_at(0), indices = test::entry_at(1);
    const auto case_of = [](std::string what, std::function<void(BakedBytes&)> spoil) {
        return std::pair{"is unsound: " + std::move(what) + kAgain, std::move(spoil)};
    };
    const std::vector<std::pair<std::string, std::function<void(BakedBytes&)>>> cases = {
        case_of("it has no room for 65 sections", [](BakedBytes& b) { write_at(b, 28, 65u); }),
        case_of("it has no room for 6 sections", [](BakedBytes& b) { write_at(b, 28, 6u); }),
        case_of("section 'numbers' is there twice, or has no name",
                [&](BakedBytes& b) { b.replace(indices, 7, "numbers"); }),
        case_of("section '' is there twice, or has no name", [&](BakedBytes& b) { b[numbers] = '\0'; }),
        case_of("section 'numbers' has an entry that means nothing",
                [&](BakedBytes& b) { write_at(b, numbers + 36, 1u); }),
        case_of("section 'numbers' has an entry that means nothing",
                [&](BakedBytes& b) { write_at(b, numbers + 32, 0u); }),
        case_of("section 'numbers' is not aligned to 64 bytes",
                [&](BakedBytes& b) { write_at(b, numbers + 16, std::uint64_t{193}); }),
        case_of("section 'numbers' overlaps what is before it",
                [&](BakedBytes& b) { write_at(b, numbers + 16, std::uint64_t{64}); }),
        case_of("section 'indices' overlaps what is before it",
                [&](BakedBytes& b) { write_at(b, indices + 16, std::uint64_t{192}); }),
        case_of("section 'indices' reaches beyond the end of the file",
                [&](BakedBytes& b) { write_at(b, indices + 16, std::uint64_t{1} << 63); }),
        case_of("section 'indices' reaches beyond the end of the file",
                [&](BakedBytes& b) { write_at(b, indices + 24, std::uint64_t{6}); }),
        case_of("section 'indices' reaches beyond the end of the file",
                [&](BakedBytes& b) { write_at(b, indices + 24, std::uint64_t{1} << 62 | 5); }),
        case_of("something lies behind its last section",
                [&](BakedBytes& b) { write_at(b, indices + 24, std::uint64_t{4}); }),
        case_of("section 'numbers' is missing", [&](BakedBytes& b) { b[numbers] = 'N'; }),
        case_of("section 'numbers' has records of 4 bytes; expected 8",
                [&](BakedBytes& b) { write_at(b, numbers + 32, 4u); })};
    for (const auto& [sentence, spoil] : cases) {
        BakedBytes bytes = sample();
        spoil(bytes);
        test::seal(bytes);
        CHECK(refusal(bytes) == sentence);
    }
}

TEST_CASE("whether a file is baked is told by how it begins", "[unit]") {
    const test::Folder folder;
    CHECK(is_baked_file(folder.write("baked", sample())));
    CHECK_FALSE(is_baked_file(folder.write("other", "v 0 0 0\nv 0 0 1\n")));
    CHECK_FALSE(is_baked_file(folder.write("short", "ORBWBAK")));
    CHECK_FALSE(is_baked_file(folder.path("none")));
    CHECK_FALSE(is_baked_file(folder.path()));
}
