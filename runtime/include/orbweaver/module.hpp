#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "orbweaver/diagnostic.hpp"
#include "orbweaver/fault.hpp"
#include "orbweaver/options.hpp"
#include "orbweaver/random.hpp"
#include "orbweaver/report.hpp"
#include "orbweaver/state.hpp"
#include "orbweaver/vec3.hpp"

namespace orbweaver {

/// The stages of a frame, in the order they run. Within a stage modules run providers before
/// consumers, ties by name.
enum class Phase : std::uint8_t { sense, act, integrate, constrain, derive, present };

/// One fixed step of the scene's clock: from `time` to `time + step`.
struct Frame {
    std::uint64_t index = 0;
    double time = 0;  ///< s, at the start of the frame: index * step
    double step = 0;  ///< s
};

/// What holds for the whole scene.
struct SceneInfo {
    std::string name;
    std::string directory;  ///< of the scene file; relative paths in options start here
    double duration = 0;    ///< s
    double step = 0;        ///< s, one frame
    std::uint64_t seed = 0;
    Vec3 gravity;  ///< m/s^2
};

/// What this run was asked to leave behind, for modules that draw or record.
struct Request {
    bool window = false;
    bool pictures = false;         ///< draw even when nothing is recorded and no window is open
    std::string frames_directory;  ///< empty: none
    std::string video_file;        ///< empty: none
    int width = 0;                 ///< pixels; 0: as the scene says
    int height = 0;
    double frames_per_second = 0;  ///< of pictures; 0: one a frame
    int threads = 1;
    /// Contracts of which the run itself asks every provider, those without a table in the scene included.
    std::vector<std::string> collects;
};

enum class LogLevel : std::uint8_t { debug, info, warning };

/// What the host offers to one module instance. Valid from attach() until the instance is destroyed.
class Host {
public:
    virtual const std::string& instance_name() const noexcept = 0;
    virtual const Options& options() const noexcept = 0;
    virtual const SceneInfo& scene() const noexcept = 0;
    virtual const Request& request() const noexcept = 0;
    virtual StateStore& state() noexcept = 0;
    virtual void log(LogLevel level, std::string_view sentence) = 0;
    /// Collects a fault of the scene or of an asset; attach() may go on to find more. The run does not start.
    virtual void report_fault(Diagnostic fault) = 0;
    /// A column of --telemetry; its name ends in its unit ("energy_j"). `value` is asked at the end of every
    /// frame, only when somebody records; it must not throw.
    virtual void telemetry(std::string name, std::function<double()> value) = 0;

    /// Whether the run is to end now. A module may then give up a frame that would take long: it throws
    /// Fault(stopped) in run(), the state at the frame's start is kept, and the run ends as it would have
    /// before that frame. False outside of run().
    virtual bool stop_asked() const = 0;

    /// A stream of this instance's own: independent of every other name and instance.
    RandomStream random(std::string_view stream) const {
        return {scene().seed, instance_name() + "/" + std::string(stream)};
    }

    /// Offers an implementation of a contract that the manifest's `provides` names.
    template <class Contract>
    void provide(Contract& implementation) {
        provide_contract(Contract::kContract, &implementation);
    }
    /// The one provider of a contract that the manifest `needs` or `uses`; null only for `uses`, and for what
    /// it `meets`.
    template <class Contract>
    Contract* find() const {
        const auto all = find_contract(Contract::kContract);
        return all.empty() ? nullptr : static_cast<Contract*>(all.front());
    }
    /// Every provider of a contract that the manifest `collects`, in attach order; in Module::meet() of one
    /// that it `meets`, whoever attached first.
    template <class Contract>
    std::vector<Contract*> collect() const {
        std::vector<Contract*> found;
        for (void* each : find_contract(Contract::kContract)) found.push_back(static_cast<Contract*>(each));
        return found;
    }

protected:
    ~Host() = default;
    virtual void provide_contract(std::string_view contract, void* implementation) = 0;
    virtual std::vector<void*> find_contract(std::string_view contract) const = 0;
};

/// One instance of a loadable module. Members may throw Fault (or anything): the boundary turns it
/// into a FaultRecord. All state that changes over time lives in host.state(); members are constants
/// and caches that restored() can rebuild.
class Module {
public:
    virtual ~Module() = default;
    Module() = default;
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;

    /// Builds the instance: reads options, makes state arrays, provides and finds contracts.
    virtual void attach(Host& host) = 0;
    /// Every module of the scene is attached, without a fault: finds the contracts that the manifest `meets`,
    /// and may report faults of what they lack.
    virtual void meet(Host&) {}
    /// Called for the phases that the manifest lists, once a frame (present: once a picture).
    virtual void run(Phase phase, const Frame& frame) = 0;
    /// The state block was just overwritten from a snapshot: rebuild caches.
    virtual void restored() {}
    /// After the last frame, whatever the outcome: close files. Not called when attach() failed.
    virtual void finish() {}
    virtual void report(ModuleReport&) {}
};

}  // namespace orbweaver
