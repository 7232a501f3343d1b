#pragma once

#include <ctime>

namespace orbweaver::peers {

/// Processor time of this process since it was made: other guests of a machine take less of it than of the
/// wall's.
class Stopwatch {
public:
    double seconds() const { return now() - start_; }

private:
    static double now() {
        std::timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    }
    double start_ = now();
};

}  // namespace orbweaver::peers
