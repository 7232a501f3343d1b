#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "build.hpp"
#include "grip_options.hpp"
#include "manifest_text.hpp"
#include "mesh_cache.hpp"
#include "mesh_file.hpp"
#include "mesh_surface.hpp"
#include "mesh_ways.hpp"
#include "orbweaver/entry.hpp"
#include "shapes.hpp"
#include "shown_lines.hpp"
#include "tree_file.hpp"
#include "walker.hpp"

namespace orbweaver::surface {
namespace {

/// The mesh as the scene wants it: where it was made, or scaled and moved.
class PlacedMesh {
public:
    PlacedMesh(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& tree, std::optional<double> size,
               const Vec3& position)
        : mesh_(mesh), tree_(tree) {
        const Vec3 extent = mesh_.bounds.max - mesh_.bounds.min;
        const double scale = size ? *size / std::max({extent.x, extent.y, extent.z}) : 1;
        if (scale == 1 && position == Vec3{}) return;
        const auto placed = [&](const Vec3& p) { return scale * p + position; };
        vertices_.reserve(mesh_.vertices.size());
        for (const Vec3& v : mesh_.vertices) vertices_.push_back(placed(v));
        mesh_.vertices = vertices_;
        mesh_.bounds = {placed(mesh_.bounds.min), placed(mesh_.bounds.max)};
        // The tree's boxes are in a frame of their own: only that moves. Their rounding is wider than ours.
        if (tree_) tree_->frame = {placed(tree_->frame.middle), scale * tree_->frame.size};
    }

    const mesh::SurfaceMesh& mesh() const noexcept { return mesh_; }
    const std::optional<WideTree>& tree() const noexcept { return tree_; }
    std::size_t memory_bytes() const noexcept { return vertices_.capacity() * sizeof(Vec3); }

private:
    mesh::SurfaceMesh mesh_;
    std::optional<WideTree> tree_;
    std::vector<Vec3> vertices_;
};

template <class T, class Get>
std::optional<T> given(const Options& options, const char* key, Get get) {
    return options.has(key) ? std::optional<T>((options.*get)(key)) : std::nullopt;
}

/// A level square about the origin, its upper side up.
mesh::RawMesh flat_floor(double edge) {
    const double half = edge / 2;
    mesh::RawMesh raw;
    raw.points = {{-half, 0, -half}, {-half, 0, half}, {half, 0, half}, {half, 0, -half}};
    raw.material_names = {"floor"};
    raw.add_polygon({0, 1, 2, 3});
    return raw;
}

mesh::RawMesh shape_of(const Options& options) {
    const auto shapes = mesh::shapes();
    const auto shape = std::find_if(shapes.begin(), shapes.end(), [&](const mesh::Shape& each) {
        return each.name == options.text("shape");
    });
    return shape->make(1, static_cast<std::uint32_t>(options.integer("subdivision")));
}

/// The [surface] table: maps its mesh, or makes its shape, and offers it to whoever walks. Nothing of it
/// changes over time.
class SurfaceModule final : public Module {
public:
    void attach(Host& host) override {
        const Options& options = host.options();
        const int kinds = options.has("mesh") + options.has("shape") + options.has("floor");
        if (kinds != 1) {
            host.report_fault({options.where("mesh"),
                               kinds == 0 ? "the surface has no mesh, no shape and no flat floor"
                                          : "the surface has more than one of a mesh, a shape and a flat floor",
                               "mesh = \"file\", shape = \"cliff\" or floor = \"4 m\"",
                               kinds == 0 ? "add one to [surface]" : "leave all but one out"});
            return;
        }
        if (options.has("floor") && options.has("size")) {
            host.report_fault({options.where("size"), "'size' scales a mesh, and this surface is a flat floor",
                               "", "leave it out: 'floor' is the floor's edge"});
            return;
        }
        try {
            open(host);
        } catch (const Fault& fault) {
            if (fault.kind() != FaultKind::invalid) throw;
            host.report_fault({options.where("mesh"), fault.what(), "", ""});
            return;
        }
        ways_.emplace(*surface_);
        host.provide<Surface>(*surface_);
        host.provide<SurfaceWays>(*ways_);
        lines_.draw(*surface_, host);
        host.provide<Threads>(lines_);
    }

    void run(Phase, const Frame&) override {
        if (surface_->out_of_memory())
            throw Fault(FaultKind::limit, "no memory for a tree or records over the surface's " +
                                              std::to_string(surface_->faces().size()) +
                                              " triangles; bake the mesh with its tree, or use a coarser one");
    }

    void report(ModuleReport& report) override {
        if (!surface_) return;
        const ReadyParts& parts = surface_->parts();
        report.memory_bytes = placed_->memory_bytes() + parts.tree_bytes() + parts.faces_bytes();
        report.measure("triangles", static_cast<std::int64_t>(surface_->faces().size()));
        report.measure("size_m", surface_->size());
        report.measure("tree", std::string(surface_->is_treeless()  ? "none: so few triangles need none"
                                           : parts.tree_is_baked()  ? "baked"
                                           : parts.tree_bytes() > 0 ? "made when first asked for"
                                                                    : "none: nobody asked for it"));
    }

private:
    void open(Host& host) {
        const Options& options = host.options();
        mesh::SurfaceMesh mesh;
        std::optional<WideTree> tree;
        if (!options.has("mesh")) {
            mesh::Validation validation;
            const bool flat = options.has("floor");
            made_ = mesh::build_surface_mesh(flat ? flat_floor(options.number("floor")) : shape_of(options), {},
                                             flat ? "the flat floor" : "the shape", validation);
            mesh = made_.view();
        } else {
            file_.emplace(mesh::open_mesh(options.text("mesh")));
            mesh = mesh::mesh_in(*file_);
            tree = tree_in(*file_, triangles_of(mesh));
        }
        placed_.emplace(mesh, tree, given<double>(options, "size", &Options::number),
                        options.vector("position"));
        surface_.emplace(placed_->mesh(), placed_->tree(), grips_of(placed_->mesh(), host));
    }

    mesh::SurfaceMeshData made_;  // of a shape or a floor
    std::optional<BakedFile> file_;
    std::optional<PlacedMesh> placed_;
    std::optional<MeshSurface> surface_;
    std::optional<MeshWays> ways_;
    ShownLines lines_;
};

}  // namespace
}  // namespace orbweaver::surface

ORBWEAVER_MODULE(orbweaver::surface::SurfaceModule)
