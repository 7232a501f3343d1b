#pragma once

#include <dlfcn.h>

#include <catch2/catch.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "orbweaver/entry.hpp"

namespace orbweaver::test {

/// A host for one module or a few, whose every answer a test can set and every report it can read.
class FakeHost final : public Host {
public:
    Options options_;
    SceneInfo scene_;
    Request request_;
    std::vector<std::string> logged;
    Diagnostics faults;
    std::map<std::string, std::vector<void*>, std::less<>> contracts;

    template <class Contract>
    void offer(Contract& implementation) {
        contracts[Contract::kContract].push_back(&implementation);
    }
    void set(std::string key, OptionValue value, Location where = {}) {
        options_.set(std::move(key), std::move(value), std::move(where));
    }

    const std::string& instance_name() const noexcept override { return name_; }
    const Options& options() const noexcept override { return options_; }
    const SceneInfo& scene() const noexcept override { return scene_; }
    const Request& request() const noexcept override { return request_; }
    StateStore& state() noexcept override { std::terminate(); }
    void log(LogLevel, std::string_view sentence) override { logged.emplace_back(sentence); }
    void report_fault(Diagnostic fault) override { faults.push_back(std::move(fault)); }
    void telemetry(std::string, std::function<double()>) override {}
    bool stop_asked() const override { return false; }

protected:
    void provide_contract(std::string_view contract, void* implementation) override {
        contracts[std::string(contract)].push_back(implementation);
    }
    std::vector<void*> find_contract(std::string_view contract) const override {
        const auto found = contracts.find(contract);
        return found == contracts.end() ? std::vector<void*>{} : found->second;
    }

private:
    std::string name_ = "test";
};

/// One instance of a module that was built, driven through its descriptor as the host does.
class LoadedModule {
public:
    explicit LoadedModule(const std::string& id) {
        // Kept mapped to the end, so that a leak checker can still name whose memory it finds.
        const std::string path = std::string(ORBWEAVER_MODULE_DIR) + "/" + id + ".so";
        library_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
        INFO((library_ == nullptr ? dlerror() : path.c_str()));
        REQUIRE(library_ != nullptr);
        descriptor_ = reinterpret_cast<EntryFunction>(dlsym(library_, kEntryName))();
        module_ = descriptor_->create(fault);
        REQUIRE(module_ != nullptr);
    }
    LoadedModule(const LoadedModule&) = delete;
    LoadedModule& operator=(const LoadedModule&) = delete;
    ~LoadedModule() {
        descriptor_->destroy(module_);
        dlclose(library_);
    }

    bool attach(Host& host) { return descriptor_->attach(*module_, host, fault); }
    bool run(std::uint64_t index = 0) {
        return descriptor_->run(*module_, Phase::present, {index, 0, 0}, fault);
    }
    bool finish() { return descriptor_->finish(*module_, fault); }
    ModuleReport report() {
        ModuleReport report;
        REQUIRE(descriptor_->report(*module_, report, fault));
        return report;
    }

    FaultRecord fault;

private:
    void* library_ = nullptr;
    const ModuleDescriptor* descriptor_ = nullptr;
    Module* module_ = nullptr;
};

}  // namespace orbweaver::test
