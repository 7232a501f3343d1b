#include "limited_child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <new>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWatch = 10;          // ms between looks at the child's memory
constexpr char kAnswer = 'A';       // an answer follows
constexpr char kOutOfMemory = 'M';  // an allocation failed
constexpr char kFault = 'F';        // the kind of a Fault follows, then its sentence

/// Sanitizers reserve terabytes of addresses: under them only the watch ends what grows.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

void limit(decltype(RLIMIT_FSIZE) what, rlim_t value) {
    const rlimit both{value, value};
    ::setrlimit(what, &both);
}

void restrict_child(const ChildLimits& limits) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_CORE, 0);
    if (!kSanitized) limit(RLIMIT_AS, 2 * limits.memory);
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGPIPE, SIGXFSZ, SIGINT, SIGTERM})
        ::signal(signal, SIG_DFL);
    const int null = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
}

void send(int pipe, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::write(pipe, bytes.data(), bytes.size());
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) ::_exit(1);
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
}

[[noreturn]] void be_child(int pipe, const ChildLimits& limits,
                           const std::function<std::string()>& work) noexcept {
    restrict_child(limits);
    try {
        const std::string answer = work();
        send(pipe, std::string_view(&kAnswer, 1));
        send(pipe, answer);
    } catch (const std::bad_alloc&) {
        send(pipe, std::string_view(&kOutOfMemory, 1));
    } catch (const Fault& fault) {
        send(pipe, std::string{kFault, static_cast<char>(fault.kind())} + fault.what());
    }  // anything else ends the child by a signal: it is a crash
    ::_exit(0);
}

std::size_t resident_bytes(pid_t child) {
    std::ifstream file(fmt::format("/proc/{}/statm", child));
    std::size_t all = 0, resident = 0;
    file >> all >> resident;
    return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

/// A child while it works; gone, whatever happens, when this is.
class Child {
public:
    Child(const std::string& name, const ChildLimits& limits, const std::function<std::string()>& work)
        : name_(name), limits_(limits) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail("made");
        pid_ = ::fork();
        if (pid_ == 0) {
            ::close(ends[0]);
            be_child(ends[1], limits, work);
        }
        ::close(ends[1]);
        pipe_ = ends[0];
        if (pid_ < 0) fail("started");
    }
    ~Child() {
        if (pipe_ >= 0) ::close(pipe_);
        if (pid_ <= 0) return;
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// All that the child sent, until it closes its end.
    std::string listen() {
        const auto end = Clock::now() + std::chrono::duration<double>(limits_.seconds);
        std::string heard;
        std::vector<char> piece(1 << 20);
        for (;;) {
            if (Clock::now() > end) out_of_time();
            if (resident_bytes(pid_) > limits_.memory || heard.size() > limits_.memory) out_of_memory();
            pollfd ready{pipe_, POLLIN, 0};
            if (::poll(&ready, 1, kWatch) <= 0) continue;
            const ssize_t got = ::read(pipe_, piece.data(), piece.size());
            if (got < 0 && errno != EINTR) fail("heard");
            if (got == 0) return heard;
            heard.append(piece.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
        }
    }

    /// How it ended: its wait status.
    int wait() {
        int status = 0;
        ::waitpid(pid_, &status, 0);
        pid_ = 0;
        return status;
    }

    [[noreturn]] void out_of_memory() const {
        throw Fault(FaultKind::limit,
                    fmt::format("{}: importing it takes more than {} MB of memory; simplify the mesh, "
                                "or allow more with --memory-limit",
                                name_, limits_.memory >> 20));
    }
    [[noreturn]] void out_of_time() const {
        throw Fault(FaultKind::limit,
                    fmt::format("{}: importing it takes longer than {:g} s; simplify the mesh, or allow "
                                "more with --time-limit",
                                name_, limits_.seconds));
    }

private:
    [[noreturn]] void fail(const char* doing) const {
        throw Fault(FaultKind::internal, fmt::format("{}: no importer can be {}: {}; try again", name_, doing,
                                                     std::strerror(errno)));
    }

    const std::string& name_;
    const ChildLimits& limits_;
    pid_t pid_ = -1;
    int pipe_ = -1;
};

}  // namespace

std::string run_in_child(const std::string& name, const ChildLimits& limits,
                         const std::function<std::string()>& work) {
    Child child(name, limits, work);
    std::string heard = child.listen();
    const int status = child.wait();
    if (WIFSIGNALED(status) || heard.empty()) {
        const std::string how =
            WIFSIGNALED(status) ? ::strsignal(WTERMSIG(status)) : "it ended without an answer";
        throw Fault(
            FaultKind::invalid,
            fmt::format("{}: the importer crashed on it ({}); export the mesh again, or in another format",
                        name, how));
    }
    if (heard[0] == kOutOfMemory) child.out_of_memory();
    if (heard[0] == kFault && heard.size() > 1) throw Fault(static_cast<FaultKind>(heard[1]), heard.substr(2));
    heard.erase(0, 1);
    return heard;
}

}  // namespace orbweaver
