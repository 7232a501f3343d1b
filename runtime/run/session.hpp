#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "run/instance.hpp"

namespace orbweaver {

/// A plan brought to life: its modules loaded, attached and stepped in the declared order.
class Session {
public:
    /// Loads and attaches every module of the plan. Throws Fault; scene faults that modules found while
    /// attaching are in faults(), and then the session must not be stepped.
    Session(Plan plan, Request request);
    ~Session();

    const Diagnostics& faults() const noexcept { return faults_; }
    const SceneInfo& scene() const noexcept { return scene_; }
    const std::vector<std::unique_ptr<Instance>>& instances() const noexcept { return instances_; }

    std::uint64_t frame() const noexcept { return frame_; }  ///< frames done
    double time() const noexcept { return static_cast<double>(frame_) * scene_.step; }
    void set_frame(std::uint64_t frame) noexcept { frame_ = frame; }

    /// One frame: sense, act, integrate, constrain, derive. On a Fault every module's state is again what
    /// it was before the frame. False, and the same, when a module gave it up since `stop_asked` said yes.
    bool step(const std::function<bool()>& stop_asked = {});
    /// Draws the present state, and has it recorded unless told otherwise.
    void present(bool recording = true);
    /// Tells every module that the run is over. Throws the first failure after telling all.
    void finish();

    /// XXH3 of every state array in attach order, and of the frame number.
    std::uint64_t state_hash() const;
    /// The first provider of a contract, or null.
    template <class Contract>
    Contract* find() const {
        const auto found = contracts_.find(Contract::kContract);
        return found == contracts_.end() ? nullptr : static_cast<Contract*>(found->second.front());
    }
    /// Every provider of a contract, in attach order.
    template <class Contract>
    std::vector<Contract*> collect() const {
        std::vector<Contract*> all;
        if (const auto found = contracts_.find(Contract::kContract); found != contracts_.end())
            for (void* each : found->second) all.push_back(static_cast<Contract*>(each));
        return all;
    }

private:
    void load(Plan& plan);
    void unload() noexcept;
    void run_phase(Phase phase, const std::function<bool()>& stop_asked);
    void keep_state();
    void put_state_back();

    SceneInfo scene_;
    Request request_;
    Contracts contracts_;
    std::vector<std::unique_ptr<Instance>> instances_;
    Diagnostics faults_;
    std::uint64_t frame_ = 0;
    std::vector<unsigned char> last_good_;
};

}  // namespace orbweaver
