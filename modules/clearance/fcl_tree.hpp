#pragma once

#include <memory>

#include "triangle_set.hpp"

namespace orbweaver::surface {

/// The tree of boxes that FCL builds, walked front to back for rays. FCL itself casts no rays.
class FclTree {
public:
    explicit FclTree(const TriangleSet& set);  ///< reads `set` for as long as it lives
    ~FclTree();
    FclTree(const FclTree&) = delete;
    FclTree& operator=(const FclTree&) = delete;

    /// The nearest crossing. No crossing that the triangle test accepts is passed over: boxes are widened by
    /// the rounding of that test.
    SurfaceHit first_hit(const SurfaceRay& ray) const noexcept;

    std::size_t memory_bytes() const noexcept;

private:
    struct Model;
    TriangleSet set_;
    std::unique_ptr<Model> model_;
};

}  // namespace orbweaver::surface
