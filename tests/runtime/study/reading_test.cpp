#include "study/reading.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <functional>

#include "orbweaver/random.hpp"
#include "run/interrupt.hpp"
#include "support/fake_reader.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

namespace {

/// A folder that alone is searched, with a program in it that may read.
struct OnlyReader {
    Folder folder;
    Surrounded path{"PATH", folder.path()};

    explicit OnlyReader(const std::string& lines) { write_script(folder, "tesseract", lines); }
    Reader find() const {
        const auto reader = Reader::find();
        REQUIRE(reader);
        return *reader;
    }
};

picture::GrayPicture shades(int width, int height) {
    picture::GrayPicture picture{width, height, {}};
    const RandomStream random(1, "shades");
    for (int i = 0; i < width * height; ++i)
        picture.shades.push_back(static_cast<std::uint8_t>(random.bits(static_cast<std::uint64_t>(i))));
    return picture;
}

/// What is said on standard error while a call runs.
std::string errors_of(const Folder& folder, const std::function<void()>& call) {
    const int before = ::dup(STDERR_FILENO);
    const int file = ::open(folder.path("errors").c_str(), O_CREAT | O_WRONLY, 0600);
    ::dup2(file, STDERR_FILENO);
    call();
    ::dup2(before, STDERR_FILENO);
    ::close(before);
    ::close(file);
    return read_file(folder.path("errors"));
}

/// By the definition, over every way to begin.
std::size_t edits(const std::string& a, const std::string& b) {
    if (a.empty() || b.empty()) return a.size() + b.size();
    const std::string rest_a = a.substr(1), rest_b = b.substr(1);
    if (a[0] == b[0]) return edits(rest_a, rest_b);
    return 1 + std::min({edits(rest_a, b), edits(a, rest_b), edits(rest_a, rest_b)});
}

std::string random_word(std::uint64_t seed) {
    const RandomStream random(seed, "word");
    std::string word;
    for (std::uint64_t i = 1; i <= random.bits(0) % 7; ++i) word += static_cast<char>('A' + random.bits(i) % 3);
    return word;
}

}  // namespace

TEST_CASE("there is a reader only where PATH has a program of its name that may be run", "[unit]") {
    const Folder folder;
    const auto found = [](const std::optional<std::string>& path) {
        const Surrounded surrounded("PATH", path);
        return Reader::find().has_value();
    };
    folder.write("plain/tesseract", "#!/bin/sh\n");  // not to be run
    std::filesystem::create_directories(folder.path("sources/tesseract"));
    write_script(folder, "other/tesseract4", "");
    const std::string none = folder.path("plain") + ":" + folder.path("sources") + "::" + folder.path("other") +
                             ":" + folder.path("missing");
    CHECK_FALSE(found(none));
    CHECK_FALSE(found(""));
    CHECK_FALSE(found(std::nullopt));
    std::filesystem::create_directories(folder.path("bin"));
    write_script(folder, "bin/tesseract", "");
    CHECK(found(none + ":" + folder.path("bin")));
}

TEST_CASE("the first reader in PATH is the one that reads", "[unit]") {
    const Folder folder;
    for (const std::string each : {"one", "two"}) {
        std::filesystem::create_directories(folder.path(each));
        write_script(folder, each + "/tesseract", "echo " + each + "\n");
    }
    const Surrounded path("PATH", folder.path("two") + ":" + folder.path("one"));
    CHECK(Reader::find()->read(shades(1, 1)) == "two\n");
}

TEST_CASE("the reader is given the picture as a gray map, as one block of capitals and nothing between pages",
          "[unit]") {
    const OnlyReader only("/bin/cat > $0.seen\nprintf '%s\\n' \"$@\" > $0.asked\n");
    const picture::GrayPicture picture = shades(300, 400);  // more than a pipe holds
    CHECK(only.find().read(picture).empty());
    const std::string seen = read_file(only.folder.path("tesseract.seen"));
    const std::string head = "P5\n300 400\n255\n";
    REQUIRE(seen.size() == head.size() + 300 * 400);
    CHECK(seen.substr(0, head.size()) == head);
    CHECK(std::equal(picture.shades.begin(), picture.shades.end(), seen.begin() + head.size(),
                     [](std::uint8_t shade, char byte) { return shade == static_cast<std::uint8_t>(byte); }));
    CHECK(read_file(only.folder.path("tesseract.asked")) ==
          "stdin\nstdout\n--psm\n6\n-c\ntessedit_char_whitelist=ABCDEFGHIJKLMNOPQRSTUVWXYZ\n-c\n"
          "page_separator=\n");
}

TEST_CASE("all that the reader says is heard, but for its complaints", "[unit]") {
    const OnlyReader only("echo careful >&2\ni=0\nwhile [ $i -lt 3000 ]; do echo L$i; i=$((i+1)); done\n");
    std::string all, heard;
    for (int i = 0; i < 3000; ++i) all += "L" + std::to_string(i) + "\n";
    CHECK(errors_of(only.folder, [&] { heard = only.find().read(shades(2, 2)); }).empty());
    CHECK(heard == all);
}

TEST_CASE("the reader's surroundings are ours, but for its threads", "[unit]") {
    const OnlyReader only("echo $ORBWEAVER_ASIDE $OMP_THREAD_LIMIT\n");
    const Surrounded aside("ORBWEAVER_ASIDE", "kept"), threads("OMP_THREAD_LIMIT", std::nullopt);
    CHECK(only.find().read(shades(1, 1)) == "kept 1\n");
}

TEST_CASE("a reader that fails is told from one that reads nothing", "[unit]") {
    const auto failure = [](const OnlyReader& only) {
        CHECK(kind_of_fault([&] { only.find().read(shades(1, 1)); }) == FaultKind::internal);
        return fault_of([&] { only.find().read(shades(1, 1)); });
    };
    const OnlyReader silent(":\n");
    CHECK(silent.find().read(shades(1, 1)).empty());
    const OnlyReader fails("echo PIG\nexit 1\n");
    CHECK(failure(fails) ==
          fails.folder.path("tesseract") + " failed; see whether it reads a picture by itself");
    const OnlyReader dies("kill -9 $$\n");
    CHECK(failure(dies) == dies.folder.path("tesseract") + " failed; see whether it reads a picture by itself");
    const OnlyReader gone("");
    const Reader reader = gone.find();
    std::filesystem::remove(gone.folder.path("tesseract"));
    CHECK(fault_of([&] { reader.read(shades(1, 1)); }) ==
          gone.folder.path("tesseract") + " could not be run: No such file or directory");
}

TEST_CASE("errors of characters are edits by their definition, over what was written", "[unit]") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        const std::string read = random_word(2 * seed), written = random_word(2 * seed + 1) + "A";
        CAPTURE(read, written);
        CHECK(character_error_rate(read, written) ==
              static_cast<double>(edits(read, written)) / static_cast<double>(written.size()));
    }
}

TEST_CASE("line ends and spaces are no errors, and what is longer may be worse than nothing", "[unit]") {
    CHECK(character_error_rate("SOME \n PIG\n\f", "SOMEP\nIG") == 0);
    CHECK(character_error_rate("", "SOME PIG") == 1);
    CHECK(character_error_rate("XXXXXX", "PIG") == 2);
    CHECK(character_error_rate("pig", "PIG") == 1);
    CHECK(character_error_rate(" \n", " ") == 0);
    CHECK(character_error_rate("A", "\n") == 1);
}

TEST_CASE("the reader chooses among the letters of the alphabet that it is given", "[unit]") {
    const OnlyReader only("echo \"$6\"\n");
    CHECK(only.find().read(shades(1, 1), "Ab=,\"\\") == "tessedit_char_whitelist=Ab=,\"\\\n");
}

TEST_CASE("a reader that hangs is ended as soon as a stop is asked for", "[extreme]") {
    const OnlyReader only("trap '' INT TERM\necho $$ > $0.works\nwhile true; do :; done\n");
    const std::string works = only.folder.path("tesseract.works");
    const auto stop_asked = [&] { return std::filesystem::exists(works) && !read_file(works).empty(); };
    const auto start = std::chrono::steady_clock::now();
    CHECK(kind_of_fault([&] { only.find().read(shades(1, 1), "A", stop_asked); }) == FaultKind::stopped);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(20));
    CHECK(::kill(std::stoi(read_file(works)), 0) != 0);
}

TEST_CASE("signals of the terminal are ours, and none is kept from the reader", "[unit]") {
    const Interrupt interrupt;
    const OnlyReader only("/usr/bin/cut -d' ' -f5 /proc/$$/stat\nexec /bin/grep SigBlk /proc/self/status\n");
    const std::string said = only.find().read(shades(1, 1));
    CHECK(std::stoi(said) != ::getpgrp());
    CHECK_THAT(said, Catch::EndsWith("SigBlk:\t0000000000000000\n"));
}

TEST_CASE("an alphabet has the kinds of characters that a text has, and its signs", "[unit]") {
    const std::string capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ", small = "abcdefghijklmnopqrstuvwxyz";
    CHECK(alphabet_of("SOME\nPIG") == capitals);
    CHECK(alphabet_of("pig") == small);
    CHECK(alphabet_of("Pig 7!") == capitals + small + "0123456789!");
    CHECK(alphabet_of("?-?") == "?-");
    CHECK(alphabet_of("\u00e9t\u00e9") == small + "\u00e9");
    CHECK(alphabet_of("").empty());
}

TEST_CASE("the first character beyond ASCII is what the reader may not know", "[unit]") {
    CHECK_FALSE(unreadable_in("Some pig, 7!\n~"));
    CHECK(unreadable_in("CAF\u00c9 \u6f22") == "\u00c9");
    CHECK(unreadable_in("\U0001f437") == "\U0001f437");
}

TEST_CASE("errors are counted in characters, whatever bytes they have, and without white space", "[unit]") {
    struct Case {
        const char *read, *written;
        double rate;
    };
    for (const auto& [read, written, rate] : std::vector<Case>{{"SOME\nPIG\n", "SOME PIG", 0},
                                                               {"SOMEPIC", "SOME PIG", 1.0 / 7},
                                                               {"some pig", "SOME PIG", 1},
                                                               {"", "PIG", 1},
                                                               {"PIG", "", 1},
                                                               {" ", "", 0},
                                                               {"ABCDEF", "XY", 3},
                                                               {"CAFE", "CAF\u00c9", 0.25},
                                                               {"CAF\u00c9", "CAF\u00c9", 0},
                                                               {"\u00c9", "\u00c8", 1}}) {
        CAPTURE(read, written);
        CHECK(character_error_rate(read, written) == Approx(rate));
    }
}
