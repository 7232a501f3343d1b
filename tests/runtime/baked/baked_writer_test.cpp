#include "baked/baked_writer.hpp"

#include <catch2/catch.hpp>

#include "orbweaver/fault.hpp"
#include "support/file_size_limit.hpp"
#include "support/folder.hpp"

using namespace orbweaver;

namespace {

const std::vector<double> kNumbers(1000, 0.25);

BakedWriter sample() {
    BakedWriter writer("sample", 1, {3, 4});
    writer.add("numbers", std::span(kNumbers));
    writer.add("none", std::span<const double>());
    return writer;
}

}  // namespace

TEST_CASE("the same sections give the same bytes", "[unit]") {
    const test::Folder folder;
    sample().write(folder.path("a"));
    sample().write(folder.path("b"));
    CHECK(test::read_file(folder.path("a")) == test::read_file(folder.path("b")));
}

TEST_CASE("a section may be empty", "[unit]") {
    const test::Folder folder;
    sample().write(folder.path("f"));
    CHECK(BakedFile(folder.path("f"), "sample", 1).section<double>("none").empty());
}

TEST_CASE("a single record is kept, though it and the first writer are gone", "[unit]") {
    const test::Folder folder;
    const auto with_record = [] {
        BakedWriter writer = sample();
        const std::vector<double> temporary = {4.5};
        writer.add_record("record", temporary[0]);
        return std::vector<BakedWriter>(2, writer)[1];
    };
    with_record().write(folder.path("f"));
    CHECK(BakedFile(folder.path("f"), "sample", 1).section<double>("record")[0] == 4.5);
}

TEST_CASE("a disk that fills up leaves the file that was there, and no piece of a new one", "[unit]") {
    const test::Folder folder;
    folder.write("f", "before");
    {
        const test::FileSizeLimit full(4096);
        CHECK_THROWS_AS(sample().write(folder.path("f")), Fault);
    }
    CHECK(test::read_file(folder.path("f")) == "before");
    CHECK(folder.names() == std::vector<std::string>{"f"});
}

TEST_CASE("names that do not fit are a mistake of the program's", "[unit]") {
    const test::Folder folder;
    BakedWriter writer("sample", 1, {});
    writer.add("a_name_of_17_char", std::span(kNumbers));
    CHECK_THROWS_WITH(writer.write(folder.path("f")),
                      "'a_name_of_17_char' does not fit a name of a baked file");
}
