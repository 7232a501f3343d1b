#include "run/frame_loop.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <thread>

#include "orbweaver/contracts/input.hpp"
#include "output/progress.hpp"
#include "run/snapshot.hpp"

namespace orbweaver {

namespace {

using Clock = std::chrono::steady_clock;

bool run_headless(Session& session, const LoopSettings& settings, const Interrupt& interrupt,
                  const std::function<void()>& recorded) {
    const Request& request = settings.request;
    const std::uint64_t first = session.frame();
    const bool draws = !request.frames_directory.empty() || !request.video_file.empty();
    const std::uint64_t end = frame_count(session.scene().duration, session.scene().step);
    Progress progress(session.scene().name, first, end, session.scene().step, settings.quiet);
    while (session.frame() < end) {
        if (interrupt.requested()) return false;
        const bool due =
            draws && picture_due(session.frame() - first, session.scene().step, request.frames_per_second);
        if (!session.step([&] { return interrupt.requested(); })) return false;
        recorded();
        if (due) session.present();
        progress.update(session.frame());
    }
    return true;
}

/// A session in a window: paced by the wall clock, driven by keys.
class WindowLoop {
public:
    WindowLoop(Session& session, const LoopSettings& settings, Input& input)
        : session_(session),
          settings_(settings),
          input_(input),
          first_(session.frame()),
          first_state_(save_snapshot(session)),
          end_(settings.endless ? std::numeric_limits<std::uint64_t>::max()
                                : frame_count(session.scene().duration, session.scene().step)) {}

    bool run(const Interrupt& interrupt, const std::function<void()>& recorded) {
        std::fputs((std::string(input_.key_list()) + "\n").c_str(), stderr);
        next_ = Clock::now();
        while (session_.frame() < end_) {
            const InputEvents& events = input_.poll();
            if (events.quit || interrupt.requested()) return false;
            obey(events);
            session_.present(step(interrupt, recorded));
            wait();
        }
        return true;
    }

private:
    // One frame, unless time stands still. Whether a picture of it is to be recorded.
    bool step(const Interrupt& interrupt, const std::function<void()>& recorded) {
        if (paused_ && steps_ == 0) return false;
        const bool due =
            picture_due(session_.frame() - first_, session_.scene().step, settings_.request.frames_per_second);
        if (!session_.step([&] { return interrupt.requested(); })) return false;
        recorded();
        if (steps_ > 0) --steps_;
        return due;
    }
    void obey(const InputEvents& events) {
        if (events.toggle_pause) paused_ = !paused_;
        if (paused_) steps_ += events.steps;
        if (events.reset) restore_snapshot(session_, first_state_, "the first frame");
        if (events.help) std::fputs((std::string(input_.key_list()) + "\n").c_str(), stderr);
    }
    // A run slower than real time does not try to catch up.
    void wait() {
        next_ = std::max(next_ + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(session_.scene().step)),
                         Clock::now());
        std::this_thread::sleep_until(next_);
    }

    Session& session_;
    const LoopSettings& settings_;
    Input& input_;
    std::uint64_t first_;
    std::string first_state_;
    std::uint64_t end_;
    Clock::time_point next_;
    bool paused_ = false;
    int steps_ = 0;
};

}  // namespace

std::uint64_t frame_count(double duration, double step) {
    if (duration <= 0) return 0;
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(duration / step)));
}

bool picture_due(std::uint64_t index, double step, double pictures_per_second) {
    if (pictures_per_second <= 0 || index == 0) return true;
    constexpr double kRounding = 1e-9;
    const auto pictures_by = [&](std::uint64_t frames) {
        return std::floor(static_cast<double>(frames) * step * pictures_per_second + kRounding);
    };
    return pictures_by(index) > pictures_by(index - 1);
}

bool run_frames(Session& session, const LoopSettings& settings, const Interrupt& interrupt,
                const std::function<void()>& recorded) {
    if (auto* input = session.find<Input>(); settings.request.window && input != nullptr)
        return WindowLoop(session, settings, *input).run(interrupt, recorded);
    return run_headless(session, settings, interrupt, recorded);
}

}  // namespace orbweaver
