#include "run/instance.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>

namespace orbweaver {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Instance::Instance(PlannedModule planned, std::shared_ptr<const LoadedModule> library, const SceneInfo& scene,
                   const Request& request, Contracts& contracts)
    : planned_(std::move(planned)),
      library_(std::move(library)),
      scene_(scene),
      request_(request),
      contracts_(contracts) {
    FaultRecord record;
    module_ = library_->descriptor().create(record);
    if (module_ == nullptr)
        throw LoadError(LoadFault::cannot_create,
                        fmt::format("module '{}' cannot be made: {}", planned_.manifest->id, record.sentence));
}

Instance::~Instance() { library_->descriptor().destroy(module_); }

void Instance::fail(const char* doing, const FaultRecord& record) const {
    throw Fault(record.kind,
                fmt::format("module '{}' failed {}: {}", planned_.instance, doing, record.sentence));
}

void Instance::attach() {
    const auto start = Clock::now();
    FaultRecord record;
    const bool good = library_->descriptor().attach(*module_, *this, record);
    setup_seconds_ = seconds_since(start);
    if (!good) fail("while attaching", record);
    if (!faults_.empty()) return;
    for (const std::string& contract : planned_.manifest->provides)
        if (std::find(provided_.begin(), provided_.end(), contract) == provided_.end())
            throw Fault(FaultKind::internal,
                        fmt::format("module '{}' did not provide {}, which its manifest promises",
                                    planned_.instance, contract));
}

void Instance::meet() {
    FaultRecord record;
    if (!library_->descriptor().meet(*module_, *this, record)) fail("while meeting the others", record);
}

void Instance::run(Phase phase, const Frame& frame, const std::function<bool()>& stop_asked) {
    const auto start = Clock::now();
    FaultRecord record;
    stop_asked_ = &stop_asked;
    const bool good = library_->descriptor().run(*module_, phase, frame, record);
    stop_asked_ = nullptr;
    wall_seconds_ += seconds_since(start);
    if (!good) fail(fmt::format("in frame {}, phase {}", frame.index, to_string(phase)).c_str(), record);
}

void Instance::restored() {
    FaultRecord record;
    if (!library_->descriptor().restored(*module_, record)) fail("while taking up a restored state", record);
}

void Instance::finish() {
    FaultRecord record;
    if (!library_->descriptor().finish(*module_, record)) fail("while finishing", record);
}

ModuleReport Instance::report() {
    ModuleReport report;
    FaultRecord record;
    if (!library_->descriptor().report(*module_, report, record)) fail("while reporting", record);
    return report;
}

bool Instance::takes_part_in(Phase phase) const noexcept {
    const auto& phases = planned_.manifest->phases;
    return std::find(phases.begin(), phases.end(), phase) != phases.end();
}

void Instance::log(LogLevel level, std::string_view sentence) {
    static constexpr spdlog::level::level_enum levels[] = {spdlog::level::debug, spdlog::level::info,
                                                           spdlog::level::warn};
    spdlog::log(levels[static_cast<std::size_t>(level)], "{}: {}", planned_.instance, sentence);
}

void Instance::telemetry(std::string name, std::function<double()> value) {
    telemetry_.push_back({std::move(name), std::move(value)});
}

void Instance::provide_contract(std::string_view contract, void* implementation) {
    const auto& promised = planned_.manifest->provides;
    if (std::find(promised.begin(), promised.end(), contract) == promised.end())
        throw Fault(FaultKind::internal,
                    fmt::format("it provides {}, which its manifest does not promise", contract));
    contracts_[std::string(contract)].push_back(implementation);
    provided_.emplace_back(contract);
}

std::vector<void*> Instance::find_contract(std::string_view contract) const {
    const auto found = contracts_.find(contract);
    return found == contracts_.end() ? std::vector<void*>{} : found->second;
}

}  // namespace orbweaver
