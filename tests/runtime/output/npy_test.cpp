#include "output/npy.hpp"

#include <catch2/catch.hpp>

#include "support/file_size_limit.hpp"
#include "support/npy.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

TEST_CASE("rows come back with their type, shape and bits", "[unit]") {
    const Folder folder;
    const std::string path = folder.path("a.npy");
    NpyWriter writer(path, "<f8", {2, 3});
    const std::vector<double> first{0.1, -2, 3e300, 4, 5e-324, 6};
    const std::vector<double> second{7, 8, 9, 10, 11, 12};
    writer.append(first.data(), 48);
    writer.append(second.data(), 48);
    CHECK(writer.rows() == 2);
    CHECK_FALSE(std::filesystem::exists(path));
    writer.commit();
    const Npy read(path);
    CHECK(read.type == "<f8");
    CHECK(read.shape == std::vector<std::size_t>{2, 2, 3});
    std::vector<double> both = first;
    both.insert(both.end(), second.begin(), second.end());
    CHECK(read.values<double>() == both);
}

TEST_CASE("numbers a row, whole words, and no rows at all are arrays too", "[unit]") {
    const Folder folder;
    NpyWriter times(folder.path("time.npy"), "<f8", {});
    for (double t : {0.0, 0.5, 1.0}) times.append(&t, sizeof t);
    times.commit();
    CHECK(Npy(folder.path("time.npy")).shape == std::vector<std::size_t>{3});
    CHECK(Npy(folder.path("time.npy")).values<double>() == std::vector<double>{0, 0.5, 1});

    NpyWriter words(folder.path("words.npy"), "<u8", {1});
    const std::uint64_t word = 0xfedcba9876543210ULL;
    words.append(&word, sizeof word);
    words.commit();
    CHECK(Npy(folder.path("words.npy")).type == "<u8");
    CHECK(Npy(folder.path("words.npy")).values<std::uint64_t>() == std::vector<std::uint64_t>{word});

    NpyWriter none(folder.path("none.npy"), "<f8", {7, 3});
    none.commit();
    CHECK(Npy(folder.path("none.npy")).shape == std::vector<std::size_t>{0, 7, 3});

    NpyWriter empty(folder.path("empty.npy"), "<f8", {0, 3});
    empty.append(nullptr, 0);
    empty.commit();
    CHECK(Npy(folder.path("empty.npy")).shape == std::vector<std::size_t>{1, 0, 3});
}

TEST_CASE("an array that outgrows the disk is a limit and leaves no file", "[extreme]") {
    const Folder folder;
    const auto fill = [&] {
        const FileSizeLimit limit(65536);
        NpyWriter writer(folder.path("a.npy"), "<f8", {1000});
        const std::vector<double> row(1000);
        for (int i = 0; i < 100; ++i) writer.append(row.data(), 8000);
        writer.commit();
    };
    CHECK(kind_of_fault(fill) == FaultKind::limit);
    CHECK(folder.names().empty());
}
