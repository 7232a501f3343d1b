#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "manifest_text.hpp"
#include "mesh_cache.hpp"
#include "mesh_file.hpp"
#include "mesh_surface.hpp"
#include "orbweaver/entry.hpp"
#include "tree_file.hpp"
#include "walker.hpp"

namespace orbweaver::surface {
namespace {

/// The mesh as the scene wants it: where the file has it, or scaled and moved.
class PlacedMesh {
public:
    PlacedMesh(const BakedFile& file, std::optional<double> size, const Vec3& position)
        : mesh_(mesh::mesh_in(file)), tree_(tree_in(file, triangles_of(mesh_))) {
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

/// The [surface] table: maps its mesh and offers it to whoever walks. Nothing of it changes over time.
class SurfaceModule final : public Module {
public:
    void attach(Host& host) override {
        const Options& options = host.options();
        if (!options.has("mesh")) {
            host.report_fault({options.where("mesh"), "the surface has no mesh", "mesh = \"file\"",
                               "add 'mesh' to [surface]"});
            return;
        }
        try {
            open(options);
        } catch (const Fault& fault) {
            if (fault.kind() != FaultKind::invalid) throw;
            host.report_fault({options.where("mesh"), fault.what(), "", ""});
            return;
        }
        host.provide<Surface>(*surface_);
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
        report.memory_bytes =
            placed_->memory_bytes() + parts.tree_bytes() + parts.faces_bytes() + surface_->clearance_bytes();
        report.measure("triangles", static_cast<std::int64_t>(surface_->faces().size()));
        report.measure("size_m", surface_->size());
        report.measure("tree", std::string(parts.tree_is_baked()    ? "baked"
                                           : parts.tree_bytes() > 0 ? "made when first asked for"
                                                                    : "none: nobody asked for it"));
        report.measure("clearance_tree",
                       std::string(surface_->clearance_bytes() > 0 ? "made when first asked for"
                                                                   : "none: nobody asked for it"));
    }

private:
    void open(const Options& options) {
        file_.emplace(mesh::open_mesh(options.text("mesh")));
        placed_.emplace(*file_, given<double>(options, "size", &Options::number), options.vector("position"));
        surface_.emplace(placed_->mesh(), placed_->tree(),
                         GripOverride{given<double>(options, "friction", &Options::number),
                                      given<bool>(options, "climbable", &Options::flag)});
    }

    std::optional<BakedFile> file_;
    std::optional<PlacedMesh> placed_;
    std::optional<MeshSurface> surface_;
};

}  // namespace
}  // namespace orbweaver::surface

ORBWEAVER_MODULE(orbweaver::surface::SurfaceModule)
