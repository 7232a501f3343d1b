#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "load/loader.hpp"
#include "plan/plan.hpp"
#include "run/state_block.hpp"

namespace orbweaver {

/// Who provides which contract, in attach order.
using Contracts = std::map<std::string, std::vector<void*>, std::less<>>;

struct TelemetryColumn {
    std::string name;
    std::function<double()> value;
};

/// One module instance with all that the host keeps for it. Every call of the module goes through here:
/// a failure comes out as a Fault whose sentence begins with the instance's name.
class Instance final : public Host {
public:
    Instance(PlannedModule planned, std::shared_ptr<const LoadedModule> library, const SceneInfo& scene,
             const Request& request, Contracts& contracts);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    void attach();
    void meet();
    /// `stop_asked` answers Host::stop_asked() meanwhile; empty: no.
    void run(Phase phase, const Frame& frame, const std::function<bool()>& stop_asked = {});
    void restored();
    void finish();
    ModuleReport report();

    bool takes_part_in(Phase phase) const noexcept;
    const Manifest& manifest() const noexcept { return *planned_.manifest; }
    const std::vector<TelemetryColumn>& telemetry_columns() const noexcept { return telemetry_; }
    const Diagnostics& faults() const noexcept { return faults_; }
    const StateBlock& block() const noexcept { return state_; }
    StateBlock& block() noexcept { return state_; }
    double setup_seconds() const noexcept { return setup_seconds_; }  ///< s in attach()
    double wall_seconds() const noexcept { return wall_seconds_; }    ///< s in run()

    const std::string& instance_name() const noexcept override { return planned_.instance; }
    const Options& options() const noexcept override { return planned_.options; }
    const SceneInfo& scene() const noexcept override { return scene_; }
    const Request& request() const noexcept override { return request_; }
    StateStore& state() noexcept override { return state_; }
    void log(LogLevel level, std::string_view sentence) override;
    void report_fault(Diagnostic fault) override { faults_.push_back(std::move(fault)); }
    void telemetry(std::string name, std::function<double()> value) override;
    bool stop_asked() const override { return stop_asked_ != nullptr && *stop_asked_ && (*stop_asked_)(); }

protected:
    void provide_contract(std::string_view contract, void* implementation) override;
    std::vector<void*> find_contract(std::string_view contract) const override;

private:
    [[noreturn]] void fail(const char* doing, const FaultRecord& record) const;

    PlannedModule planned_;
    std::shared_ptr<const LoadedModule> library_;
    const SceneInfo& scene_;
    const Request& request_;
    Contracts& contracts_;
    StateBlock state_;
    std::vector<std::string> provided_;
    std::vector<TelemetryColumn> telemetry_;
    Diagnostics faults_;
    double setup_seconds_ = 0;
    double wall_seconds_ = 0;
    Module* module_ = nullptr;
    const std::function<bool()>* stop_asked_ = nullptr;  ///< while it runs
};

}  // namespace orbweaver
