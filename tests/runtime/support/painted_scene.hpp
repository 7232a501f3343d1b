#pragma once

#include <spdlog/spdlog.h>

#include <string>

#include "run/run_scene.hpp"
#include "support/folder.hpp"
#include "support/program.hpp"

namespace orbweaver::test {

/// A scene of which the fixtures' view paints squares: frames of 0.1 s.
struct PaintedScene {
    Folder folder;
    RunSettings run;

    explicit PaintedScene(const std::string& tables) {
        spdlog::set_level(spdlog::level::warn);
        run.scene_path = folder.write("scene.toml", "[scene]\nduration = 1\nstep = 0.1\n" + tables);
        run.module_directories = {fixture("view"), fixture("inscription")};
        run.quiet = true;
    }
};

}  // namespace orbweaver::test
