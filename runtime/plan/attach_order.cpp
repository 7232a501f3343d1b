#include "plan/attach_order.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace orbweaver {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// What is still to be placed, by manifest: all modules of one get ready together, so that thousands of them
/// cost no more than their number.
class Waiting {
public:
    explicit Waiting(const std::vector<PlannedModule>& modules) {
        for (std::size_t i = 0; i < modules.size(); ++i) {
            places_[modules[i].manifest].push_back(i);
            ++unplaced_[modules[i].manifest];
        }
    }

    /// Moves to `ready` whatever waits for nothing that is unplaced.
    void release(std::set<std::size_t>& ready) {
        std::erase_if(places_, [&](const auto& entry) {
            if (waits(*entry.first)) return false;
            ready.insert(entry.second.begin(), entry.second.end());
            return true;
        });
    }

    /// True when it was the last of its manifest.
    bool place(const Manifest* manifest) { return --unplaced_[manifest] == 0; }

    std::set<std::size_t> rest() const {
        std::set<std::size_t> all;
        for (const auto& [manifest, places] : places_) all.insert(places.begin(), places.end());
        return all;
    }

private:
    bool waits(const Manifest& consumer) const {
        return std::any_of(unplaced_.begin(), unplaced_.end(), [&](const auto& entry) {
            const auto& [provider, count] = entry;
            const std::size_t others = provider == &consumer ? count - 1 : count;
            return others > 0 && wants(consumer, *provider);
        });
    }

    std::map<const Manifest*, std::vector<std::size_t>> places_;
    std::map<const Manifest*, std::size_t> unplaced_;
};

}  // namespace

bool wants(const Manifest& consumer, const Manifest& provider) {
    for (const auto* wanted : {&consumer.needs, &consumer.uses, &consumer.collects})
        for (const std::string& contract : *wanted)
            if (contains(provider.provides, contract)) return true;
    return false;
}

AttachOrder attach_order(std::vector<PlannedModule> modules) {
    std::stable_sort(modules.begin(), modules.end(),
                     [](const auto& a, const auto& b) { return a.instance < b.instance; });
    AttachOrder order;
    Waiting waiting(modules);
    std::set<std::size_t> ready;
    waiting.release(ready);
    while (!ready.empty()) {
        PlannedModule& next = modules[*ready.begin()];
        ready.erase(ready.begin());
        const bool last = waiting.place(next.manifest);
        order.modules.push_back(std::move(next));
        if (last) waiting.release(ready);
    }
    for (const std::size_t i : waiting.rest()) {
        order.circle.push_back(modules[i].instance);
        order.modules.push_back(std::move(modules[i]));
    }
    return order;
}

}  // namespace orbweaver
