#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace orbweaver {

/// Progress on standard error: one line redrawn in place on a terminal, a plain line now and then elsewhere.
class Progress {
public:
    Progress(std::string what, std::uint64_t total, double seconds_per_unit, bool quiet);
    ~Progress();

    void update(std::uint64_t done);

private:
    void show(std::uint64_t done, double elapsed) const;

    using Clock = std::chrono::steady_clock;
    std::string what_;
    std::uint64_t total_;
    double seconds_per_unit_;
    bool quiet_;
    bool terminal_;
    Clock::time_point start_;
    Clock::time_point shown_;
    bool drawn_ = false;
};

}  // namespace orbweaver
