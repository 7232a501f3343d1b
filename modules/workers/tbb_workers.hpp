#pragma once

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/task_arena.h>

#include "orbweaver/contracts/workers.hpp"

namespace orbweaver::workers {

/// oneTBB's threads behind the contract. The calling thread is one of them.
class TbbWorkers final : public Workers {
public:
    /// `threads` >= 1; more than the machine has processors is obeyed.
    explicit TbbWorkers(int threads);
    TbbWorkers(const TbbWorkers&) = delete;
    TbbWorkers& operator=(const TbbWorkers&) = delete;
    /// Waits until every thread is gone, so that the library may be unloaded.
    ~TbbWorkers();

    void parallel_for(std::size_t count, std::size_t grain, Body body, void* context) noexcept override;
    int threads() const noexcept { return threads_; }

private:
    int threads_;
    tbb::task_scheduler_handle scheduler_;
    tbb::global_control limit_;
    tbb::task_arena arena_;
};

}  // namespace orbweaver::workers
