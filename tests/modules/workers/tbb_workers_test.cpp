#include "tbb_workers.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <mutex>
#include <vector>

using orbweaver::workers::TbbWorkers;

TEST_CASE("every index is visited once, in ranges no shorter than the grain but the last", "[unit]") {
    for (const int threads : {1, 2, 4}) {
        TbbWorkers workers(threads);
        for (const std::size_t count : {0, 1, 7, 64, 1000, 4099}) {
            for (const std::size_t grain : {0, 1, 64, 5000}) {
                std::vector<std::atomic<int>> visits(count);
                std::mutex mutex;
                std::size_t short_ranges = 0;
                workers.for_each_range(count, grain, [&](std::size_t begin, std::size_t end) noexcept {
                    for (std::size_t i = begin; i < end; ++i) ++visits[i];
                    const std::scoped_lock lock(mutex);
                    short_ranges += end - begin < grain && end != count ? 1 : 0;
                });
                bool once = true;
                for (const auto& each : visits) once = once && each == 1;
                CHECK(once);
                CHECK(short_ranges == 0);
            }
        }
    }
}

TEST_CASE("workers come and go again and again", "[extreme]") {
    for (int round = 0; round < 20; ++round) {
        TbbWorkers workers(3);
        std::atomic<std::size_t> sum = 0;
        workers.for_each_range(1000, 10,
                               [&](std::size_t begin, std::size_t end) noexcept { sum += end - begin; });
        CHECK(sum == 1000);
    }
}
