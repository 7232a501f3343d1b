#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace orbweaver {

/// `orbweaver-assets inspect F [--json] [--png OUT]`: what a baked file holds.
class InspectCommand {
public:
    explicit InspectCommand(CLI::App& app);
    bool parsed() const { return command_->parsed(); }
    int run() const;

private:
    int inspect_target() const;
    int inspect_mesh() const;

    CLI::App* command_;
    std::string file_;
    bool json_ = false;
    std::string png_;
};

/// `orbweaver-assets verify F`: proves a baked file sound.
class VerifyCommand {
public:
    explicit VerifyCommand(CLI::App& app);
    bool parsed() const { return command_->parsed(); }
    int run() const;

private:
    CLI::App* command_;
    std::string file_;
};

}  // namespace orbweaver
