#include "study/reading.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kOnlyCapitals = "tessedit_char_whitelist=ABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// Bytes in memory that a child may read or write as a file.
class MemoryFile {
public:
    MemoryFile() : descriptor_(memfd_create("reading", 0)) {
        if (descriptor_ < 0) fail("memory for a picture to be read could not be had");
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(descriptor_); }

    int descriptor() const noexcept { return descriptor_; }
    void put(const std::vector<std::uint8_t>& bytes) {
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t some = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
            if (some <= 0) fail("a picture to be read could not be written");
            done += static_cast<std::size_t>(some);
        }
        ::lseek(descriptor_, 0, SEEK_SET);
    }
    std::string all() {
        ::lseek(descriptor_, 0, SEEK_SET);
        std::string text;
        std::array<char, 4096> some;
        for (ssize_t count; (count = ::read(descriptor_, some.data(), some.size())) > 0;)
            text.append(some.data(), static_cast<std::size_t>(count));
        return text;
    }

    [[noreturn]] static void fail(const std::string& what) {
        throw Fault(FaultKind::internal, what + ": " + std::generic_category().message(errno));
    }

private:
    int descriptor_;
};

std::string letters_of(const std::string& text) {
    std::string letters;
    for (const char each : text)
        if (std::isspace(static_cast<unsigned char>(each)) == 0) letters += each;
    return letters;
}

/// A portable gray map: what the reader takes and needs no library, which would stay loaded in every run.
std::vector<std::uint8_t> pgm_of(const picture::GrayPicture& picture) {
    const std::string head =
        "P5\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
    std::vector<std::uint8_t> bytes(head.begin(), head.end());
    bytes.insert(bytes.end(), picture.shades.begin(), picture.shades.end());
    return bytes;
}

}  // namespace

std::optional<Reader> Reader::find() {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path program = fs::path(folder) / "tesseract";
        std::error_code error;
        if (fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0)
            return Reader(program.string());
    }
    return std::nullopt;
}

std::string Reader::read(const picture::GrayPicture& picture) const {
    MemoryFile seen, said;
    seen.put(pgm_of(picture));
    // Some versions end a page in a form feed unless told otherwise.
    std::array<std::string, 9> words = {program_, "stdin",       "stdout", "--psm",          "6",
                                        "-c",     kOnlyCapitals, "-c",     "page_separator="};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::string threads = "OMP_THREAD_LIMIT=1";  // the study's other processes need cores too
    std::vector<char*> surroundings;
    for (char** each = environ; *each != nullptr; ++each) surroundings.push_back(*each);
    surroundings.push_back(threads.data());
    surroundings.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, seen.descriptor(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, said.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    errno = posix_spawn(&child, program_.c_str(), &files, nullptr, arguments.data(), surroundings.data());
    posix_spawn_file_actions_destroy(&files);
    if (errno != 0) MemoryFile::fail(program_ + " could not be run");
    int status = 0;
    if (::waitpid(child, &status, 0) != child || status != 0)
        throw Fault(FaultKind::internal, program_ + " failed; see whether it reads a picture by itself");
    return said.all();
}

double character_error_rate(const std::string& read, const std::string& written) {
    const std::string a = letters_of(read), b = letters_of(written);
    if (b.empty()) return a.empty() ? 0 : 1;
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t above = row[j + 1];
            row[j + 1] = std::min({above + 1, row[j] + 1, diagonal + (a[i] == b[j] ? 0 : 1)});
            diagonal = above;
        }
    }
    return static_cast<double>(row.back()) / static_cast<double>(b.size());
}

}  // namespace orbweaver::study
