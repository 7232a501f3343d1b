#pragma once

#include <spdlog/spdlog.h>

#include <string>

#include "run/interrupt.hpp"
#include "sanitized.hpp"
#include "study/subject.hpp"
#include "study/time_budget.hpp"
#include "support/folder.hpp"
#include "support/program.hpp"

namespace orbweaver::test {

/// A scene with the oscillator of the fixtures, to be studied: 20 frames of 10 ms, omega = 10/s, so 0.32
/// periods.
struct OscillatorScene {
    Folder folder;
    study::StudySettings settings;
    Interrupt interrupt;
    study::Deadline deadline = study::deadline_in(kSanitized ? 600 : 60, interrupt);

    explicit OscillatorScene(const std::string& options = "") {
        spdlog::set_level(spdlog::level::warn);
        settings.run.scene_path = folder.write(
            "scene.toml",
            "[scene]\nname = \"swing\"\nduration = 0.2\nstep = 0.01\n[oscillator]\n" + options + "\n");
        settings.run.module_directories = {fixture("oscillator")};
        settings.run.quiet = true;
        settings.out = folder.path("out");
        settings.repeats = 1;
    }
};

}  // namespace orbweaver::test
