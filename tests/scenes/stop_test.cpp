#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "run/frame_loop.hpp"
#include "shipped_scenes.hpp"

using namespace orbweaver;

TEST_CASE("a frame that a stop gives up leaves the state as it was before it", "[scene]") {
    const OpenScene scene = open_scene("strand");
    for (int i = 0; i < 3; ++i) REQUIRE(scene.session->step());
    const std::uint64_t before = scene.session->state_hash();
    CHECK_FALSE(scene.session->step([] { return true; }));
    CHECK(scene.session->frame() == 3);
    CHECK(scene.session->state_hash() == before);
    CHECK(scene.session->step([] { return false; }));
    CHECK(scene.session->frame() == 4);
}

TEST_CASE("a signal ends a run within a frame that takes long", "[scene]") {
    const Interrupt interrupt;
    // Ten million steps of some microseconds.
    const OpenScene scene = open_scene(
        "strand", {}, {"web.method=rk4", "web.step=1e-9", "web.max_substeps=1000000000", "scene.step=0.01"});
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::thread sender([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        ::kill(::getpid(), SIGINT);
    });
    CHECK_FALSE(run_frames(*scene.session, {{}, false, true}, interrupt, [] {}));
    sender.join();
    CHECK(Clock::now() - start < std::chrono::seconds(3));
    CHECK(scene.session->frame() == 0);
}
