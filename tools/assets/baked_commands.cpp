#include "baked_commands.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "baked/baked_type.hpp"
#include "mesh_file.hpp"
#include "mesh_report.hpp"
#include "output/atomic_file.hpp"
#include "target_file.hpp"
#include "target_report.hpp"
#include "verify.hpp"

namespace orbweaver {

namespace {

bool is_target(const std::string& path) { return baked_type(path) == inscription::kTargetType; }

BakedFile open_target(const std::string& path) {
    return {path, inscription::kTargetType, inscription::kTargetVersion};
}

// Also for what is neither: it is refused in words.
BakedFile open_mesh(const std::string& path) { return {path, mesh::kMeshType, mesh::kMeshVersion}; }

}  // namespace

InspectCommand::InspectCommand(CLI::App& app)
    : command_(app.add_subcommand("inspect", "print what a baked file holds, and how it was made")) {
    command_->add_option("FILE", file_, "a file that this program baked")->required();
    command_->add_flag("--json", json_, "for a program to read");
    command_->add_option("--png", png_, "draw a target into this file: black, what dilation adds in gray");
}

int InspectCommand::run() const { return is_target(file_) ? inspect_target() : inspect_mesh(); }

int InspectCommand::inspect_target() const {
    const BakedFile file = open_target(file_);
    if (!png_.empty()) {
        if (std::error_code ignored; std::filesystem::equivalent(file_, png_, ignored))
            throw CLI::ValidationError("--png", png_ + " is what is to be drawn; name another file to write");
        const auto png = target_png(file);
        AtomicFile out(png_);
        out.write(png.data(), png.size());
        out.commit();
    }
    fmt::print("{}", json_ ? target_json(file) : target_text(file));
    return 0;
}

int InspectCommand::inspect_mesh() const {
    const BakedFile file = open_mesh(file_);
    if (!png_.empty())
        throw CLI::ValidationError("--png", file_ + " holds a mesh; expected a target, which can be drawn");
    fmt::print("{}", json_ ? mesh_json(file) : mesh_text(file));
    return 0;
}

VerifyCommand::VerifyCommand(CLI::App& app)
    : command_(app.add_subcommand("verify", "prove that a baked file is whole, and that all in it agrees")) {
    command_->add_option("FILE", file_, "a file that this program baked")->required();
}

int VerifyCommand::run() const {
    if (is_target(file_)) {
        inscription::verify_target(open_target(file_));
    } else {
        const BakedFile file = open_mesh(file_);
        mesh::verify(mesh::mesh_in(file), mesh::validation_in(file), file_);
    }
    fmt::print("{}: sound\n", file_);
    return 0;
}

}  // namespace orbweaver
