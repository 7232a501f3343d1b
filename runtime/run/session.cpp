#include "run/session.hpp"

#include <cstring>
#include <exception>
#include <map>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

constexpr Phase kStepPhases[] = {Phase::sense, Phase::act, Phase::integrate, Phase::constrain, Phase::derive};

bool needs_any(const Manifest& manifest, const std::vector<std::string>& contracts) {
    for (const auto* wanted : {&manifest.needs, &manifest.uses, &manifest.collects})
        for (const std::string& contract : *wanted)
            for (const std::string& missing : contracts)
                if (contract == missing) return true;
    return false;
}

template <class Instances, class Visit>
void for_each_array(Instances& instances, Visit&& visit) {
    for (auto& instance : instances)
        for (auto& entry : instance->block().entries()) visit(entry);
}

}  // namespace

Session::Session(Plan plan, Request request) : scene_(plan.scene), request_(std::move(request)) {
    try {
        load(plan);
    } catch (...) {
        unload();
        throw;
    }
}

Session::~Session() { unload(); }

void Session::load(Plan& plan) {
    std::map<std::string, std::shared_ptr<const LoadedModule>> libraries;
    std::vector<std::string> missing;  // contracts whose provider was refused
    for (PlannedModule& planned : plan.modules) {
        const Manifest& manifest = *planned.manifest;
        auto& library = libraries[manifest.id];
        if (!library) library = std::make_shared<const LoadedModule>(manifest);
        if (needs_any(manifest, missing)) continue;
        auto instance = std::make_unique<Instance>(std::move(planned), library, scene_, request_, contracts_);
        instance->attach();
        if (!instance->faults().empty()) {
            faults_.insert(faults_.end(), instance->faults().begin(), instance->faults().end());
            missing.insert(missing.end(), manifest.provides.begin(), manifest.provides.end());
        }
        instances_.push_back(std::move(instance));
    }
    if (!faults_.empty()) return;
    for (const auto& instance : instances_) {
        instance->meet();
        faults_.insert(faults_.end(), instance->faults().begin(), instance->faults().end());
    }
}

void Session::unload() noexcept {
    while (!instances_.empty()) instances_.pop_back();  // consumers go before their providers
}

void Session::run_phase(Phase phase, const std::function<bool()>& stop_asked) {
    const Frame frame{frame_, time(), scene_.step};
    for (const auto& instance : instances_)
        if (instance->takes_part_in(phase)) instance->run(phase, frame, stop_asked);
}

void Session::keep_state() {
    last_good_.clear();
    for_each_array(instances_, [&](const StateBlock::Entry& entry) {
        const auto* bytes = static_cast<const unsigned char*>(entry.memory());
        last_good_.insert(last_good_.end(), bytes, bytes + entry.bytes());
    });
}

void Session::put_state_back() {
    const unsigned char* from = last_good_.data();
    for_each_array(instances_, [&](StateBlock::Entry& entry) {
        if (entry.bytes() > 0) std::memcpy(entry.memory(), from, entry.bytes());
        from += entry.bytes();
    });
}

bool Session::step(const std::function<bool()>& stop_asked) {
    keep_state();
    try {
        for (const Phase phase : kStepPhases) run_phase(phase, stop_asked);
    } catch (const Fault& fault) {
        put_state_back();
        if (fault.kind() == FaultKind::stopped) return false;
        throw;
    } catch (...) {
        put_state_back();
        throw;
    }
    ++frame_;
    return true;
}

void Session::present(bool recording) {
    const Frame frame{frame_, time(), scene_.step};
    for (const auto& instance : instances_)
        if (instance->takes_part_in(Phase::present) && (recording || instance->manifest().when != "recording"))
            instance->run(Phase::present, frame);
}

void Session::finish() {
    std::exception_ptr first;
    for (const auto& instance : instances_) {
        try {
            instance->finish();
        } catch (...) {
            if (!first) first = std::current_exception();
        }
    }
    if (first) std::rethrow_exception(first);
}

std::uint64_t Session::state_hash() const {
    XXH3_state_t hash;
    XXH3_64bits_reset(&hash);
    XXH3_64bits_update(&hash, &frame_, sizeof frame_);
    for_each_array(instances_, [&](const StateBlock::Entry& entry) {
        XXH3_64bits_update(&hash, entry.name.data(), entry.name.size());
        XXH3_64bits_update(&hash, entry.memory(), entry.bytes());
    });
    return XXH3_64bits_digest(&hash);
}

}  // namespace orbweaver
