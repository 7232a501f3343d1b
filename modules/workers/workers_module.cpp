#include <optional>

#include "manifest_text.hpp"
#include "orbweaver/entry.hpp"
#include "tbb_workers.hpp"

namespace orbweaver::workers {
namespace {

class WorkersModule final : public Module {
public:
    void attach(Host& host) override {
        workers_.emplace(host.request().threads);
        host.provide<Workers>(*workers_);
    }
    void run(Phase, const Frame&) override {}
    void report(ModuleReport& report) override {
        report.measure("threads", static_cast<std::int64_t>(workers_->threads()));
    }

private:
    std::optional<TbbWorkers> workers_;
};

}  // namespace
}  // namespace orbweaver::workers

ORBWEAVER_MODULE(orbweaver::workers::WorkersModule)
