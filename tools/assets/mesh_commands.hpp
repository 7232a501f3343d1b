#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "build.hpp"
#include "limited_child.hpp"

namespace orbweaver {

/// `orbweaver-assets adjacency MESH -o F`: bakes one mesh.
class AdjacencyCommand {
public:
    explicit AdjacencyCommand(CLI::App& app);
    bool parsed() const { return command_->parsed(); }
    int run() const;

private:
    mesh::Recipe recipe() const;

    CLI::App* command_;
    std::string source_;
    std::string output_;
    double weld_tolerance_ = 0;
    std::vector<std::string> friction_;
    std::vector<std::string> not_climbable_;
    double seconds_ = 120;
    std::size_t megabytes_ = 4096;
};

/// `orbweaver-assets mesh NAME -o F.obj`: writes a mesh of our own.
class MeshCommand {
public:
    explicit MeshCommand(CLI::App& app);
    bool parsed() const { return command_->parsed(); }
    int run() const;

private:
    CLI::App* command_;
    std::string name_;
    std::string output_;
    double size_ = 1;
    std::uint32_t subdivision_ = 8;
};

}  // namespace orbweaver
