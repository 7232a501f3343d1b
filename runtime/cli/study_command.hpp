#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/scene_arguments.hpp"
#include "study/study_settings.hpp"

namespace orbweaver {

/// `orbweaver study accuracy|stability|queries SCENE --out DIR`.
class StudyCommand {
public:
    explicit StudyCommand(CLI::App& app);

    bool parsed() const { return command_->parsed(); }
    /// Throws CLI::ValidationError for options that do not go together.
    void complete();
    int run() const;

private:
    CLI::App* command_;
    std::string kind_;
    SceneArguments scene_;
    study::StudySettings settings_;
    std::string time_;
    std::vector<std::string> axes_;
    CLI::Option* repeats_;
    CLI::Option* references_;
};

}  // namespace orbweaver
