#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace orbweaver {

/// Progress on standard error: one line redrawn in place on a terminal, a plain line now and then elsewhere.
/// What cannot be shown is left out: progress never ends a run.
class Progress {
public:
    /// `first` units were done before: they count neither for the pace nor for the time left. Units of no
    /// simulated length (`seconds_per_unit` 0) are not compared with real time.
    Progress(std::string what, std::uint64_t first, std::uint64_t total, double seconds_per_unit, bool quiet,
             std::string unit = "frames");
    ~Progress();

    void update(std::uint64_t done);

private:
    void show(std::uint64_t done, double elapsed) const;

    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::uint64_t first_;
    std::uint64_t total_;
    double seconds_per_unit_;
    bool quiet_;
    std::string unit_;
    bool terminal_;
    Clock::time_point start_;
    Clock::time_point shown_;
    bool drawn_ = false;
};

}  // namespace orbweaver
