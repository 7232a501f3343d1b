#include "mesh_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bake_mesh.hpp"
#include "cli/scene_arguments.hpp"
#include "mesh_file.hpp"
#include "mesh_report.hpp"
#include "obj.hpp"
#include "output/atomic_file.hpp"
#include "shapes.hpp"

namespace orbweaver {

namespace {

constexpr std::uint32_t kMostSubdivision = 4096;

/// "glass=0.1"
std::optional<std::pair<std::string, double>> parse_friction(const std::string& text) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0) return std::nullopt;
    const auto value = parse_number<double>(text.substr(equals + 1));
    if (!value || !(*value >= 0 && *value <= 1e6)) return std::nullopt;
    return std::pair{text.substr(0, equals), *value};
}

std::string check_friction(const std::string& text) {
    if (parse_friction(text)) return "";
    return fmt::format("'{}' is no MATERIAL=COEFFICIENT; expected a coefficient of 0 to 1e6, such as glass=0.1",
                       text);
}

std::vector<std::string> shape_names() {
    std::vector<std::string> names;
    for (const mesh::Shape& shape : mesh::shapes()) names.emplace_back(shape.name);
    return names;
}

}  // namespace

AdjacencyCommand::AdjacencyCommand(CLI::App& app)
    : command_(app.add_subcommand("adjacency",
                                  "bake a mesh: triangles with their neighbours, ready to be walked on")) {
    command_->add_option("MESH", source_, "the mesh, of any format that assimp reads")->required();
    command_->add_option("-o,--output", output_, "the file to write")->required();
    command_->add_option("--weld", weld_tolerance_, "m: points as near as that are one; 0: equal points alone")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    command_
        ->add_option("--friction", friction_,
                     "MATERIAL=COEFFICIENT of what is made of it; repeatable; else 0.6")
        ->allow_extra_args(false)
        ->check(check_friction);
    command_->add_option("--not-climbable", not_climbable_, "feet find no hold on this material; repeatable")
        ->allow_extra_args(false);
    command_->add_option("--time-limit", seconds_, "most seconds that the import may take")
        ->check(CLI::Range(0.1, 86400.0))
        ->capture_default_str();
    command_->add_option("--memory-limit", megabytes_, "most megabytes that the import may take")
        ->check(CLI::Range(std::size_t{16}, std::size_t{1} << 20))
        ->capture_default_str();
}

mesh::Recipe AdjacencyCommand::recipe() const {
    mesh::Recipe recipe{weld_tolerance_, {}};
    for (const std::string& each : friction_) {
        const auto [material, value] = *parse_friction(each);
        recipe.properties[material].friction = value;
    }
    for (const std::string& material : not_climbable_) recipe.properties[material].climbable = 0;
    return recipe;
}

int AdjacencyCommand::run() const {
    bake_mesh(source_, recipe(), {megabytes_ << 20, seconds_}, output_);
    fmt::print("{}", mesh_text(BakedFile(output_, mesh::kMeshType, mesh::kMeshVersion)));
    return 0;
}

MeshCommand::MeshCommand(CLI::App& app)
    : command_(app.add_subcommand("mesh", "write a mesh of our own as OBJ")) {
    command_->add_option("NAME", name_, "the shape")->required()->check(CLI::IsMember(shape_names()));
    command_->add_option("-o,--output", output_, "the file to write")->required();
    command_->add_option("--size", size_, "m, its largest extent")
        ->check(CLI::Range(1e-12, 1e12))
        ->capture_default_str();
    command_->add_option("--subdivision", subdivision_, "pieces that an edge is cut into")
        ->check(CLI::Range(1u, kMostSubdivision))
        ->capture_default_str();
}

int MeshCommand::run() const {
    const auto shape = std::find_if(mesh::shapes().begin(), mesh::shapes().end(),
                                    [&](const mesh::Shape& each) { return each.name == name_; });
    const mesh::RawMesh raw = shape->make(size_, subdivision_);
    AtomicFile file(output_);
    file.write(obj_text(raw));
    file.commit();
    fmt::print("{}: {}: {} polygons, {} points\n", output_, shape->meaning, raw.polygon_count(),
               raw.points.size());
    return 0;
}

}  // namespace orbweaver
