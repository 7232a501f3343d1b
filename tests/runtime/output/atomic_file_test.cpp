#include "output/atomic_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "support/file_size_limit.hpp"
#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

namespace {

using Names = std::vector<std::string>;

/// While one lives, this process has a common user's rights over files.
class CommonUser {
public:
    CommonUser() : dropped_(::geteuid() != 0 || ::seteuid(65534) == 0) {}
    ~CommonUser() {
        if (::geteuid() != ::getuid() && ::seteuid(::getuid()) != 0) std::abort();
    }
    bool dropped() const noexcept { return dropped_; }

private:
    bool dropped_;
};

}  // namespace

TEST_CASE("a file appears under its name when it is whole", "[unit]") {
    const Folder folder;
    AtomicFile file(folder.path("a"));
    file.write("xxxx 5");
    file.write(" 6");
    file.rewrite_front("1234");
    CHECK(folder.names() == Names{".a.part0"});
    file.commit();
    CHECK(folder.names() == Names{"a"});
    CHECK(read_file(folder.path("a")) == "1234 5 6");
}

TEST_CASE("a file that is given up leaves nothing, and the older one as it was", "[unit]") {
    const Folder folder;
    folder.write("old", "as it was");
    {
        AtomicFile given_up(folder.path("new"));
        AtomicFile replaced(folder.path("old"));
        given_up.write("half");
        replaced.write("half");
    }
    CHECK(folder.names() == Names{"old"});
    CHECK(read_file(folder.path("old")) == "as it was");
    AtomicFile file(folder.path("old"));
    file.write("new");
    file.commit();
    CHECK(read_file(folder.path("old")) == "new");
}

TEST_CASE("what cannot be written says why", "[extreme]") {
    const Folder folder;
    folder.write("file", "x");
    const std::string fifo = folder.path("fifo");
    REQUIRE(::mkfifo(fifo.c_str(), 0600) == 0);
    struct Case {
        std::string path;
        const char* sentence;
    };
    const Case cases[] = {
        {folder.path(), ": cannot be written: it is a folder; name a file"},
        {fifo, ": cannot be written: it is not a regular file; name a file"},
        {"/dev/full", ": cannot be written: it is not a regular file; name a file"},
        {"/dev/null", ": cannot be written: it is not a regular file; name a file"},
        {folder.path("file/a"),
         ": cannot be written: Not a directory; check that the folder exists and may be written"},
        {"/proc/a",
         ": cannot be written: No such file or directory; check that the folder exists and may be written"},
    };
    for (const Case& c : cases) {
        const auto open = [&] { AtomicFile file(c.path); };
        CHECK(fault_of(open) == c.path + c.sentence);
        CHECK(kind_of_fault(open) == FaultKind::internal);
    }
    CHECK(folder.names() == Names{"fifo", "file"});
    CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a read-only folder is refused in words", "[extreme]") {
    const Folder folder;
    REQUIRE(::chmod(folder.path().c_str(), 0555) == 0);
    std::string sentence;
    {
        const CommonUser user;
        if (!user.dropped()) {
            WARN("root that cannot become another user: a read-only folder cannot be had here");
            return;
        }
        sentence = fault_of([&] { AtomicFile file(folder.path("a")); });
    }
    CHECK(sentence ==
          folder.path("a") +
              ": cannot be written: Permission denied; check that the folder exists and may be written");
}

TEST_CASE("a full disk is a limit, and nothing half-written stays", "[extreme]") {
    const Folder folder;
    folder.write("old", "as it was");
    const std::string full =
        ": cannot be written: File too large; make room and run again, nothing half-written was left";
    const auto fill = [&](const std::string& name, std::size_t bytes) {
        const FileSizeLimit limit(8192);
        AtomicFile file(folder.path(name));
        file.write(std::string(bytes, 'x'));
        file.commit();
    };
    for (const std::size_t bytes : {8193u, 10000u, 1000000u}) {
        CAPTURE(bytes);
        CHECK(fault_of([&] { fill("new", bytes); }) == folder.path("new") + full);
        CHECK(kind_of_fault([&] { fill("old", bytes); }) == FaultKind::limit);
        CHECK(folder.names() == Names{"old"});
        CHECK(read_file(folder.path("old")) == "as it was");
    }
    CHECK_NOTHROW(fill("new", 8192));
}

TEST_CASE("what failed once is never completed, even if there is room again", "[extreme]") {
    const Folder folder;
    {
        AtomicFile file(folder.path("a"));
        {
            const FileSizeLimit limit(8192);
            CHECK(kind_of_fault([&] { file.write(std::string(100000, 'x')); }) == FaultKind::limit);
        }
        CHECK(kind_of_fault([&] { file.write("more"); }) == FaultKind::limit);
        CHECK(kind_of_fault([&] { file.commit(); }) == FaultKind::limit);
    }
    CHECK(folder.names().empty());
}

TEST_CASE("a link is written through, not over", "[unit]") {
    const Folder folder;
    folder.write("real", "old");
    std::filesystem::create_symlink("real", folder.path("link"));
    AtomicFile file(folder.path("link"));
    file.write("new");
    file.commit();
    CHECK(std::filesystem::is_symlink(folder.path("link")));
    CHECK(read_file(folder.path("real")) == "new");
    CHECK(folder.names() == Names{"link", "real"});
}

TEST_CASE("a link that leads nowhere yet stays, and what it names is written", "[unit]") {
    const Folder folder;
    std::filesystem::create_symlink("deep/real", folder.path("second"));
    std::filesystem::create_symlink(folder.path("second"), folder.path("first"));
    AtomicFile file(folder.path("first"));
    file.write("new");
    file.commit();
    CHECK(folder.names() == Names{"deep", "first", "second"});
    CHECK(std::filesystem::is_symlink(folder.path("first")));
    CHECK(read_file(folder.path("deep/real")) == "new");
}

TEST_CASE("two writers of one file do not mix: the last to end is what stays", "[extreme]") {
    const Folder folder;
    AtomicFile one(folder.path("a.csv"));
    AtomicFile other(folder.path("a.csv"));
    CHECK(folder.names() == Names{".a.part0.csv", ".a.part1.csv"});
    one.write(std::string(100000, '1'));
    other.write(std::string(100, '2'));
    one.commit();
    CHECK(read_file(folder.path("a.csv")) == std::string(100000, '1'));
    other.commit();
    CHECK(read_file(folder.path("a.csv")) == std::string(100, '2'));
    CHECK(folder.names() == Names{"a.csv"});
}

TEST_CASE("a link planted where a file is to grow is not followed", "[extreme]") {
    const Folder folder;
    folder.write("precious", "as it was");
    std::filesystem::create_symlink("precious", folder.path(".a.part0"));
    AtomicFile file(folder.path("a"));
    file.write("new");
    file.commit();
    CHECK(read_file(folder.path("precious")) == "as it was");
    CHECK(folder.names() == Names{".a.part0", "a", "precious"});
}

TEST_CASE("folders above a file are made, and its permissions are the user's usual", "[unit]") {
    const Folder folder;
    const auto before = ::umask(027);
    AtomicFile file(folder.path("b/c/a"));
    file.commit();
    ::umask(before);
    struct stat status {};
    REQUIRE(::stat(folder.path("b/c/a").c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0640);
}
