#pragma once

#include <optional>

#include "face_record.hpp"
#include "on_demand.hpp"
#include "walker.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// What queries want of a mesh besides itself, made when it is first asked for: the faces' records, and the
/// tree, unless that was baked.
class ReadyParts {
public:
    /// Reads `mesh` for as long as it lives.
    explicit ReadyParts(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& baked = std::nullopt)
        : baked_(baked),
          tree_([set = triangles_of(mesh)] { return std::make_unique<const Built>(set); }),
          faces_([mesh] {
              return std::make_unique<const FaceRecords>(face_records(triangles_of(mesh), mesh.across));
          }) {}

    /// Null when there was no memory for it.
    const WideTree* tree() const noexcept {
        if (baked_) return &*baked_;
        const Built* built = tree_.get();
        return built == nullptr ? nullptr : &built->tree;
    }

    /// One a face; null when there was no memory for them.
    const FaceRecord* faces() const noexcept {
        const FaceRecords* records = faces_.get();
        return records == nullptr ? nullptr : records->data();
    }

    bool tree_is_baked() const noexcept { return baked_.has_value(); }
    /// Of the tree that was made; 0 while none was.
    std::size_t tree_bytes() const noexcept {
        const Built* built = tree_.made();
        return built == nullptr ? 0 : built->data.memory_bytes();
    }
    std::size_t faces_bytes() const noexcept {
        const FaceRecords* records = faces_.made();
        return records == nullptr ? 0 : records->capacity() * sizeof(FaceRecord);
    }

private:
    struct Built {
        explicit Built(const TriangleSet& set) : data(build_wide_tree(set)), tree(data.view()) {}
        WideTreeData data;
        WideTree tree;
    };

    std::optional<WideTree> baked_;
    OnDemand<Built> tree_;
    OnDemand<FaceRecords> faces_;
};

}  // namespace orbweaver::surface
