#include "study/study_files.hpp"

#include <catch2/catch.hpp>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::study;
using namespace orbweaver::test;

TEST_CASE("files appear together, and only when they are whole", "[unit]") {
    const Folder folder;
    {
        const StudyFiles files(folder.path("a/b"), {"study.csv", "index.html"});
        CHECK_FALSE(std::filesystem::exists(folder.path("a/b/study.csv")));
    }
    CHECK(folder.names().empty());
    StudyFiles files(folder.path("a/b"), {"study.csv", "index.html"});
    files.commit({"1", "2"});
    CHECK(read_file(folder.path("a/b/study.csv")) == "1");
    CHECK(read_file(folder.path("a/b/index.html")) == "2");
}

TEST_CASE("of a study that fails those folders stay that were there, or hold something", "[unit]") {
    const Folder folder;
    folder.write("mine/note", "");
    { const StudyFiles files(folder.path("mine/new/b/"), {"study.csv"}); }
    CHECK(Folder::names_in(folder.path("mine")) == std::vector<std::string>{"note"});
    {
        const StudyFiles files(folder.path("mine/new/b"), {"study.csv"});
        folder.write("mine/new/other", "");
    }
    CHECK(Folder::names_in(folder.path("mine/new")) == std::vector<std::string>{"other"});
    std::filesystem::create_directory(folder.path("empty"));
    { const StudyFiles files(folder.path("empty"), {"study.csv"}); }
    CHECK(std::filesystem::exists(folder.path("empty")));
}

TEST_CASE("a folder that cannot be written is known at once", "[extreme]") {
    const Folder folder;
    folder.write("file", "");
    CHECK_THAT(fault_of([&] { StudyFiles(folder.path("file"), {"accuracy.csv"}); }),
               Catch::Contains("file/accuracy.csv: cannot be written"));
    CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a page escapes its title and its sentences", "[unit]") {
    CHECK_THAT(html_page("a & b", "<p>c</p>\n"), Catch::Contains("<h1>a &amp; b</h1>\n<p>c</p>\n</body>"));
    CHECK(html_list({"x < y"}) == "<ul>\n<li>x &lt; y</li>\n</ul>\n");
}
