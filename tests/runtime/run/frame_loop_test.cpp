#include "run/frame_loop.hpp"

#include <signal.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <thread>

#include "support/opened_scene.hpp"

using namespace orbweaver;
using namespace orbweaver::test;

TEST_CASE("a duration is the nearest whole number of frames, and one at least", "[unit]") {
    struct Case {
        double duration, step;
        std::uint64_t frames;
    };
    for (const Case& c :
         {Case{20, 1.0 / 60, 1200}, Case{1, 0.1, 10}, Case{0.3, 0.1, 3}, Case{0, 0.1, 0}, Case{1e-9, 0.1, 1},
          Case{0.26, 0.1, 3}, Case{1e6, 1.0 / 60, 60000000}, Case{-1, 0.1, 0}}) {
        CAPTURE(c.duration, c.step);
        CHECK(frame_count(c.duration, c.step) == c.frames);
    }
}

TEST_CASE("pictures fall due at their own rate, none twice in a frame", "[unit]") {
    const auto pictures = [](double step, double rate, std::uint64_t frames) {
        int count = 0;
        for (std::uint64_t i = 0; i < frames; ++i) count += picture_due(i, step, rate) ? 1 : 0;
        return count;
    };
    CHECK(pictures(1.0 / 60, 0, 60) == 60);
    CHECK(pictures(1.0 / 60, 60, 600) == 600);
    CHECK(pictures(1.0 / 60, 30, 600) == 300);
    CHECK(pictures(1.0 / 60, 25, 600) == 250);
    CHECK(pictures(1.0 / 60, 1, 600) == 10);
    CHECK(pictures(1.0 / 60, 1000, 60) == 60);
    CHECK(pictures(0.1, 10, 1000) == 1000);
    CHECK(pictures(1.0 / 60, 0.3, 60) == 1);
    CHECK(picture_due(0, 1.0 / 60, 30));
    CHECK_FALSE(picture_due(1, 1.0 / 60, 30));
    CHECK(picture_due(2, 1.0 / 60, 30));
}

TEST_CASE("a loop runs to the scene's end and records every frame", "[unit]") {
    const OpenedScene opened("[scene]\nduration = 1\nstep = 0.1\n[counter]\n", {"counter"});
    const Interrupt interrupt;
    int recorded = 0;
    CHECK(run_frames(*opened.session, {opened.request, false, true}, interrupt, [&] { ++recorded; }));
    CHECK(recorded == 10);
    CHECK(opened.session->frame() == 10);
}

TEST_CASE("a loop draws only when pictures were asked for, at the rate asked for", "[unit]") {
    const char* scene = "[scene]\nduration = 1\nstep = 0.05\n[counter]\n";
    const auto pictures = [&](const Request& request) {
        const OpenedScene opened(scene, {"counter"}, request);
        const Interrupt interrupt;
        run_frames(*opened.session, {opened.request, false, true}, interrupt, [] {});
        return std::get<std::int64_t>(opened.session->instances().front()->report().measures.front().second);
    };
    Request request;
    CHECK(pictures(request) == 0);
    request.frames_directory = "out";
    CHECK(pictures(request) == 20);
    request.frames_per_second = 5;
    CHECK(pictures(request) == 5);
}

TEST_CASE("an interrupted loop stops between frames", "[unit]") {
    const OpenedScene opened("[scene]\nduration = 10\nstep = 0.1\n[counter]\n", {"counter"});
    const Interrupt interrupt;
    CHECK_FALSE(run_frames(*opened.session, {opened.request, false, true}, interrupt, [&] {
        if (opened.session->frame() != 4) return;
        ::kill(::getpid(), SIGINT);
        while (!interrupt.requested()) std::this_thread::yield();
    }));
    CHECK(opened.session->frame() == 4);
}

TEST_CASE("a loop that goes on from a saved frame takes its first picture at once", "[unit]") {
    Request request;
    request.frames_directory = "out";
    request.frames_per_second = 1;
    const OpenedScene opened("[scene]\nduration = 1\nstep = 0.1\n[counter]\n", {"counter"}, request);
    opened.session->set_frame(7);
    const Interrupt interrupt;
    run_frames(*opened.session, {opened.request, false, true}, interrupt, [] {});
    const auto report = opened.session->instances().front()->report();
    CHECK(std::get<std::int64_t>(report.measures.front().second) == 1);
}
