#pragma once

#include <memory>

#include "orbweaver/contracts/clearance.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// Distances between bodies and the surface, by FCL's tree of oriented boxes and swept spheres (its tree of
/// plain boxes tells no distances). Everything is handed to FCL scaled to the surface's size, because its
/// tolerance is absolute.
class FclClearance {
public:
    explicit FclClearance(const TriangleSet& set);
    ~FclClearance();
    FclClearance(const FclClearance&) = delete;
    FclClearance& operator=(const FclClearance&) = delete;

    /// See Clearances::clearance.
    Clearance clearance(const ProbeBody& body, double reach) const noexcept;

    std::size_t memory_bytes() const noexcept;

private:
    struct Model;
    WideFrame frame_;
    std::unique_ptr<Model> model_;
};

/// Between two bodies, scaled to the larger of them.
Clearance body_clearance(const ProbeBody& body, const ProbeBody& other) noexcept;

}  // namespace orbweaver::surface
