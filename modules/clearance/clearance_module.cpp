#include <atomic>
#include <optional>
#include <string>

#include "fcl_clearance.hpp"
#include "fcl_tree.hpp"
#include "manifest_text.hpp"
#include "on_demand.hpp"
#include "orbweaver/contracts/surface_ways.hpp"
#include "orbweaver/entry.hpp"

namespace orbweaver::clearance {
namespace {

using surface::FclClearance;
using surface::OnDemand;
using surface::TriangleSet;

/// Distances from the scene's surface. FCL's tree over it is made when a body first asks.
class SurfaceClearances final : public Clearances {
public:
    explicit SurfaceClearances(const TriangleSet& set)
        : fcl_([set] { return std::make_unique<const FclClearance>(set); }) {}

    Clearance clearance(const ProbeBody& body, double reach) const noexcept override {
        const FclClearance* fcl = fcl_.get();
        return noted(fcl == nullptr ? failed() : fcl->clearance(body, reach));
    }
    Clearance clearance(const ProbeBody& body, const ProbeBody& other) const noexcept override {
        return noted(surface::body_clearance(body, other));
    }

    bool out_of_memory() const noexcept { return out_of_memory_.load(std::memory_order_relaxed); }
    /// Of FCL's tree; 0 while none was asked for.
    std::size_t memory_bytes() const noexcept {
        const FclClearance* fcl = fcl_.made();
        return fcl == nullptr ? 0 : fcl->memory_bytes();
    }

private:
    static Clearance failed() noexcept {
        Clearance clearance;
        clearance.answer = Answer::failed;
        return clearance;
    }
    Clearance noted(const Clearance& found) const noexcept {
        if (found.answer == Answer::failed) out_of_memory_.store(true, std::memory_order_relaxed);
        return found;
    }

    OnDemand<FclClearance> fcl_;
    mutable std::atomic<bool> out_of_memory_ = false;
};

/// Rays through FCL's tree, which is made at the first of them.
class FclWays final : public SurfaceWays {
public:
    explicit FclWays(const TriangleSet& set)
        : tree_([set] { return std::make_unique<const surface::FclTree>(set); }) {}

    std::span<const Way> ways() const noexcept override {
        static constexpr Way kWays[] = {{"fcl_tree", "a ray through FCL's tree of boxes", Finds::crossing}};
        return kWays;
    }
    void answer(std::size_t, std::span<const Stance> questions,
                std::span<SurfaceHit> hits) const noexcept override {
        const surface::FclTree* tree = tree_.get();
        for (std::size_t i = 0; i < questions.size(); ++i) {
            const Stance& q = questions[i];
            if (tree != nullptr)
                hits[i] = tree->first_hit({q.position, -q.up, q.reach});
            else
                hits[i].answer = Answer::failed;
        }
    }

private:
    OnDemand<surface::FclTree> tree_;
};

/// Drawn in by whoever keeps clear of things. Nothing of it changes over time.
class ClearanceModule final : public Module {
public:
    void attach(Host& host) override {
        const Surface* surface = host.find<Surface>();
        set_ = {surface->vertices(), surface->faces()};
        clearances_.emplace(set_);
        ways_.emplace(set_);
        host.provide<Clearances>(*clearances_);
        host.provide<SurfaceWays>(*ways_);
    }

    void run(Phase, const Frame&) override {
        if (clearances_->out_of_memory())
            throw Fault(FaultKind::limit, "no memory for FCL's tree over the surface's " +
                                              std::to_string(set_.triangles.size()) +
                                              " triangles; use a coarser mesh");
    }

    void report(ModuleReport& report) override {
        if (!clearances_) return;
        report.memory_bytes = clearances_->memory_bytes();
        report.measure("tree", std::string(report.memory_bytes > 0 ? "made when first asked for"
                                                                   : "none: nobody asked for it"));
    }

private:
    TriangleSet set_;
    std::optional<SurfaceClearances> clearances_;
    std::optional<FclWays> ways_;
};

}  // namespace
}  // namespace orbweaver::clearance

ORBWEAVER_MODULE(orbweaver::clearance::ClearanceModule)
