#include "study/reading.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "orbweaver/fault.hpp"

namespace orbweaver::study {

namespace {

namespace fs = std::filesystem;

constexpr useconds_t kBetweenLooks = 2000;  ///< us, at a reader that works

/// By what errno says.
[[noreturn]] void fail(const std::string& what) {
    throw Fault(FaultKind::internal, what + ": " + std::generic_category().message(errno));
}

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

private:
    int descriptor_;
};

/// The program at work, in a process group of its own: Ctrl+C ends our study, which then ends the reader in
/// order, with whatever that has started.
class Child {
public:
    Child(std::vector<std::string> words, int input, int output) : program_(words.front()) {
        std::vector<char*> arguments, surroundings;
        for (std::string& word : words) arguments.push_back(word.data());
        arguments.push_back(nullptr);
        std::string threads = "OMP_THREAD_LIMIT=1";  // the study's other processes need cores too
        for (char** each = environ; *each != nullptr; ++each) surroundings.push_back(*each);
        surroundings.push_back(threads.data());
        surroundings.push_back(nullptr);
        posix_spawn_file_actions_t files;
        posix_spawn_file_actions_init(&files);
        posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
        posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
        posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawnattr_t attributes;
        posix_spawnattr_init(&attributes);
        sigset_t none;  // what our study waits for to be told is the reader's own again
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes, &none);
        posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
        const int error =
            posix_spawn(&id_, program_.c_str(), &files, &attributes, arguments.data(), surroundings.data());
        posix_spawnattr_destroy(&attributes);
        posix_spawn_file_actions_destroy(&files);
        errno = error;
        if (error != 0) fail(program_ + " could not be run");
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        ::kill(-id_, SIGKILL);
        while (!ended_ && ::waitpid(id_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }

    /// Throws Fault(internal) once it has failed.
    bool has_ended() {
        int status = 0;
        const pid_t found = ::waitpid(id_, &status, WNOHANG);
        if (found == 0 || (found < 0 && errno == EINTR)) return false;
        ended_ = true;
        if (found != id_ || status != 0)
            throw Fault(FaultKind::internal, program_ + " failed; see whether it reads a picture by itself");
        return true;
    }

private:
    std::string program_;
    pid_t id_ = 0;
    bool ended_ = false;
};

/// The characters of a text in UTF-8 but for white space.
std::vector<std::string_view> letters_of(std::string_view text) {
    const auto goes_on = [&](std::size_t at) {
        return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
    };
    std::vector<std::string_view> letters;
    for (std::size_t begin = 0, end; begin < text.size(); begin = end) {
        end = begin + 1;
        while (goes_on(end)) ++end;
        if (std::isspace(static_cast<unsigned char>(text[begin])) == 0)
            letters.push_back(text.substr(begin, end - begin));
    }
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

std::string Reader::read(const picture::GrayPicture& picture, const std::string& alphabet,
                         const std::function<bool()>& stop_asked) const {
    MemoryFile seen, said;
    seen.put(pgm_of(picture));
    // Some versions end a page in a form feed unless told otherwise.
    Child child({program_, "stdin", "stdout", "--psm", "6", "-c", "tessedit_char_whitelist=" + alphabet, "-c",
                 "page_separator="},
                seen.descriptor(), said.descriptor());
    while (!child.has_ended()) {
        if (stop_asked && stop_asked()) throw Fault(FaultKind::stopped, program_ + " was given up");
        ::usleep(kBetweenLooks);
    }
    return said.all();
}

std::string alphabet_of(const std::string& text) {
    std::string alphabet;
    for (const auto& [first, last] : {std::pair{'A', 'Z'}, std::pair{'a', 'z'}, std::pair{'0', '9'}})
        if (std::any_of(text.begin(), text.end(),
                        [first = first, last = last](char each) { return each >= first && each <= last; }))
            for (char each = first; each <= last; ++each) alphabet += each;
    for (const std::string_view each : letters_of(text))
        if (alphabet.find(each) == std::string::npos) alphabet += each;
    return alphabet;
}

std::optional<std::string> unreadable_in(const std::string& text) {
    for (const std::string_view each : letters_of(text))
        if (each.size() > 1) return std::string(each);
    return std::nullopt;
}

double character_error_rate(const std::string& read, const std::string& written) {
    const std::vector<std::string_view> a = letters_of(read), b = letters_of(written);
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
