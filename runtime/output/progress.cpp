#include "output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace orbweaver {

Progress::Progress(std::string what, std::uint64_t first, std::uint64_t total, double seconds_per_unit,
                   bool quiet, std::string unit)
    : what_(std::move(what)),
      first_(first),
      total_(total),
      seconds_per_unit_(seconds_per_unit),
      quiet_(quiet),
      unit_(std::move(unit)),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      shown_(start_) {}

Progress::~Progress() {
    if (drawn_ && terminal_) std::fputc('\n', stderr);
}

void Progress::update(std::uint64_t done) {
    if (quiet_) return;
    const auto now = Clock::now();
    const double since = std::chrono::duration<double>(now - shown_).count();
    if (done != total_ && since < (terminal_ ? 0.1 : 5.0)) return;
    shown_ = now;
    drawn_ = true;
    show(done, std::chrono::duration<double>(now - start_).count());
}

void Progress::show(std::uint64_t done, double elapsed) const {
    const double part = total_ > 0 ? static_cast<double>(done) / static_cast<double>(total_) : 1;
    const auto here = static_cast<double>(done - first_);
    const double factor = elapsed > 0 ? here * seconds_per_unit_ / elapsed : 0;
    const double left = done > first_ ? elapsed / here * static_cast<double>(total_ - done) : 0;
    const std::string pace = seconds_per_unit_ > 0 ? fmt::format("{:.3g} x real time, ", factor) : "";
    const std::string figures =
        fmt::format("{} {}/{} {}, {}{:.0f} s left", what_, done, total_, unit_, pace, left);
    if (terminal_) {
        constexpr int kWidth = 24;
        const int filled = std::clamp(static_cast<int>(part * kWidth), 0, kWidth);
        const auto bar = std::string(static_cast<std::size_t>(filled), '#') +
                         std::string(static_cast<std::size_t>(kWidth - filled), '.');
        std::fputs(fmt::format("\r[{}] {}\033[K", bar, figures).c_str(), stderr);
    } else {
        std::fputs((figures + "\n").c_str(), stderr);
    }
}

}  // namespace orbweaver
