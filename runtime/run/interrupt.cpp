#include "run/interrupt.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

constexpr int kForever = -1;
constexpr int kSameMoment = 300;  // ms

bool is_ignored(int signal) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    return action.sa_handler == SIG_IGN;
}

// Whether the first of `files` is readable when one of them is, or when `ms` have passed.
bool first_is_ready(pollfd* files, nfds_t count, int ms) {
    while (::poll(files, count, ms) < 0 && errno == EINTR) {
    }
    return (files[0].revents & POLLIN) != 0;
}

void drain(const sigset_t& signals) {
    const timespec at_once{};
    while (::sigtimedwait(&signals, nullptr, &at_once) > 0) {
    }
}

}  // namespace

Interrupt::Interrupt() {
    sigemptyset(&watched_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (!is_ignored(signal)) sigaddset(&watched_, signal);
    signals_ = ::signalfd(-1, &watched_, SFD_CLOEXEC);
    over_ = ::eventfd(0, EFD_CLOEXEC);
    if (signals_ < 0 || over_ < 0)
        throw Fault(FaultKind::internal, std::string("signals cannot be watched: ") + std::strerror(errno));
    pthread_sigmask(SIG_BLOCK, &watched_, &before_);
    watcher_ = std::thread([this] { watch(); });
}

Interrupt::~Interrupt() {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(over_, &one, sizeof one);
    watcher_.join();
    ::close(signals_);
    ::close(over_);
    drain(watched_);  // what is still waiting would kill the moment it is unblocked
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

// After the first signal this thread lets the next one through, and with it the end of the process.
void Interrupt::watch() {
    pollfd files[] = {{over_, POLLIN, 0}, {signals_, POLLIN, 0}};
    if (first_is_ready(files, 2, kForever)) return;
    requested_ = true;
    if (first_is_ready(files, 1, kSameMoment)) return;
    drain(watched_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (sigismember(&watched_, signal) == 1) ::signal(signal, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &watched_, nullptr);
    first_is_ready(files, 1, kForever);
}

}  // namespace orbweaver
