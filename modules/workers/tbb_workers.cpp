#include "tbb_workers.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace orbweaver::workers {

TbbWorkers::TbbWorkers(int threads)
    : threads_(threads),
      scheduler_(tbb::attach{}),
      limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
      arena_(threads) {
    arena_.initialize();
}

TbbWorkers::~TbbWorkers() {
    arena_.terminate();
    tbb::finalize(scheduler_, std::nothrow);
}

void TbbWorkers::parallel_for(std::size_t count, std::size_t grain, Body body, void* context) noexcept {
    if (count == 0) return;
    const std::size_t block = std::max<std::size_t>(grain, 1);
    const std::size_t blocks = (count - 1) / block + 1;
    if (blocks == 1) return body(context, 0, count);
    // Whole blocks are shared out, so that no range but the last falls short of the grain.
    arena_.execute([&] {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks), [&](const auto& range) {
            body(context, range.begin() * block, std::min(range.end() * block, count));
        });
    });
}

}  // namespace orbweaver::workers
