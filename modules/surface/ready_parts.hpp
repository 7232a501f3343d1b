#pragma once

#include <optional>

#include "face_record.hpp"
#include "on_demand.hpp"
#include "walker.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// What queries want of a mesh besides itself, made when it is first asked for: the faces' records, and the
/// tree, or of one that was baked its corners.
class ReadyParts {
public:
    /// Reads `mesh` for as long as it lives.
    explicit ReadyParts(const mesh::SurfaceMesh& mesh, const std::optional<WideTree>& baked = std::nullopt)
        : is_baked_(baked.has_value()),
          tree_([set = triangles_of(mesh), baked] { return std::make_unique<const ReadyTree>(set, baked); }),
          faces_([mesh] {
              return std::make_unique<const FaceRecords>(face_records(triangles_of(mesh), mesh.across));
          }) {}

    /// Null when there was no memory for it.
    const WideTree* tree() const noexcept {
        const ReadyTree* ready = tree_.get();
        return ready == nullptr ? nullptr : &ready->tree;
    }

    /// One a face; null when there was no memory for them.
    const FaceRecord* faces() const noexcept {
        const FaceRecords* records = faces_.get();
        return records == nullptr ? nullptr : records->data();
    }

    bool tree_is_baked() const noexcept { return is_baked_; }
    /// Of the tree, or what was made for the baked one; 0 while none was asked for.
    std::size_t tree_bytes() const noexcept {
        const ReadyTree* ready = tree_.made();
        return ready == nullptr ? 0 : ready->made.memory_bytes();
    }
    std::size_t faces_bytes() const noexcept {
        const FaceRecords* records = faces_.made();
        return records == nullptr ? 0 : records->capacity() * sizeof(FaceRecord);
    }

private:
    struct ReadyTree {
        ReadyTree(const TriangleSet& set, const std::optional<WideTree>& baked) {
            if (baked) {
                made.corners = corners_of_leaves(*baked, set);
                tree = *baked;
                tree.corners = made.corners;
            } else {
                made = build_wide_tree(set);
                tree = made.view();
            }
        }
        WideTreeData made;
        WideTree tree;
    };

    bool is_baked_;
    OnDemand<ReadyTree> tree_;
    OnDemand<FaceRecords> faces_;
};

}  // namespace orbweaver::surface
