#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "target_recipe.hpp"

namespace orbweaver {

/// `orbweaver-assets target IMAGE | --text WORDS -o F`: bakes what is to be inscribed into a web.
class TargetCommand {
public:
    explicit TargetCommand(CLI::App& app);
    bool parsed() const { return command_->parsed(); }
    /// Throws CLI::ValidationError for a size that is none, and for neither picture nor words nor gaps.
    int run() const;

private:
    void add_picture_options();
    void add_text_options();
    inscription::TargetRecipe recipe() const;

    CLI::App* command_;
    inscription::TargetRecipe recipe_;
    std::string output_;
    std::string size_ = "600";
    std::string weight_ = "bold";
    std::string align_ = "center";
};

}  // namespace orbweaver
