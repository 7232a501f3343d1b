#pragma once

#include <optional>

#include "on_demand.hpp"
#include "wide_tree.hpp"

namespace orbweaver::surface {

/// The tree over a mesh: a baked one, or one made when it is first asked for.
class ReadyTree {
public:
    /// Reads `set` for as long as it lives.
    explicit ReadyTree(const TriangleSet& set, const std::optional<WideTree>& baked = std::nullopt)
        : baked_(baked), built_([set] { return std::make_unique<const Built>(set); }) {}

    /// Null when there was no memory for it.
    const WideTree* get() const noexcept {
        if (baked_) return &*baked_;
        const Built* built = built_.get();
        return built == nullptr ? nullptr : &built->tree;
    }

    bool is_baked() const noexcept { return baked_.has_value(); }
    /// Of the tree that was made; 0 while none was.
    std::size_t memory_bytes() const noexcept {
        const Built* built = built_.made();
        return built == nullptr ? 0 : built->data.memory_bytes();
    }

private:
    struct Built {
        explicit Built(const TriangleSet& set) : data(build_wide_tree(set)), tree(data.view()) {}
        WideTreeData data;
        WideTree tree;
    };

    std::optional<WideTree> baked_;
    OnDemand<Built> built_;
};

}  // namespace orbweaver::surface
