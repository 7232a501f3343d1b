#include "cli/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "run/current_fault.hpp"

namespace orbweaver {

namespace {

// Else the first files opened would be taken for standard output and error. open() takes the lowest that is
// free.
void open_standard_streams() {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd)
        if (::fcntl(fd, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) < 0) ::_exit(1);
}

// A reader that went away and a file that may not grow are errors of the write, to be said in words.
void ignore_signals_of_writes() {
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
}

void start_log() {
    spdlog::set_default_logger(spdlog::stderr_color_st("orbweaver"));
    spdlog::set_pattern("%^%l%$: %v");
}

int code_of(const std::function<int()>& body) {
    try {
        return body();
    } catch (...) {
        const Fault fault = current_fault();
        spdlog::error("{}", fault.what());
        return static_cast<int>(fault.kind());
    }
}

}  // namespace

int guarded_main(const std::function<int()>& body) {
    open_standard_streams();
    ignore_signals_of_writes();
    start_log();
    const int code = code_of(body);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    spdlog::error("standard output: results were lost: {}; write them elsewhere", std::strerror(errno));
    return code != 0 ? code : static_cast<int>(FaultKind::internal);
}

}  // namespace orbweaver
