#include "plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plan/attach_order.hpp"
#include "plan/scene_table.hpp"
#include "scene/nearest_name.hpp"

namespace orbweaver {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool request_matches(const std::string& when, const Request& request) {
    const bool recording = !request.frames_directory.empty() || !request.video_file.empty();
    if (when == "window") return request.window;
    if (when == "offscreen") return (recording || request.pictures) && !request.window;
    if (when == "recording") return recording;
    if (when == "pictures") return recording || request.window || request.pictures;
    if (when == "threads") return request.threads > 1;
    return true;
}

const char* request_missing(const std::string& when) {
    if (when == "window") return "nobody asked for a window (--window)";
    if (when == "offscreen") return "no picture is drawn off-screen";
    if (when == "recording") return "nobody asked for frames or a video (--frames, --video)";
    if (when == "pictures") return "nobody asked for pictures (--frames, --video or --window)";
    return "one thread was asked for (--threads)";
}

class Planner {
public:
    Planner(const Node& scene, const std::string& path, const Catalog& catalog, const Request& request)
        : scene_(scene), path_(path), catalog_(catalog), request_(request) {}

    Plan make() {
        plan_.faults = catalog_.faults;
        plan_.scene = read_scene_table(scene_, path_, plan_.faults);
        paths_ = {plan_.scene.directory, asset_directories(plan_.scene.directory)};
        for (const Member& member : *scene_.table())
            if (member.key != "scene") read_table(member);
        add_requested();
        add_collected();
        add_providers();
        check_window();
        check_contracts();
        sort_modules();
        list_left_out();
        check_rate();
        return std::move(plan_);
    }

private:
    void read_table(const Member& member) {
        const auto found = std::find_if(catalog_.manifests.begin(), catalog_.manifests.end(),
                                        [&](const Manifest& m) { return m.table == member.key; });
        if (found == catalog_.manifests.end()) return report_unknown_table(member);
        if (const Array* array = member.node.array()) {
            if (array->empty())
                plan_.faults.push_back(
                    {member.where, fmt::format("'{}' is an empty array", member.key), "a table", ""});
            if (!found->several && array->size() > 1)
                plan_.faults.push_back({member.where,
                                        fmt::format("there are {} [[{}]]", array->size(), member.key),
                                        fmt::format("one [{}]", member.key), ""});
            for (std::size_t i = 0; i < array->size(); ++i) add_asked(*found, (*array)[i], i);
        } else {
            add_asked(*found, member.node, 0);
        }
    }

    void report_unknown_table(const Member& member) {
        std::vector<std::string> names{"scene"};
        for (const Manifest& manifest : catalog_.manifests)
            if (!manifest.table.empty()) names.push_back(manifest.table);
        const std::string nearest = nearest_name(member.key, names);
        std::string remedy = nearest.empty() ? "" : fmt::format("did you mean [{}]? ", nearest);
        remedy += fmt::format("modules were searched in {}", join_names(catalog_.directories, ", "));
        plan_.faults.push_back({member.where, fmt::format("no module answers to [{}]", member.key),
                                "one of " + join_names(names), remedy});
    }

    void add_asked(const Manifest& manifest, const Node& table, std::size_t index) {
        Options options = check_options(table, manifest.options, paths_, plan_.faults);
        if (!request_matches(manifest.when, request_)) {
            unasked_.push_back(&manifest);
            return;
        }
        const std::string instance =
            index == 0 ? manifest.table : fmt::format("{}.{}", manifest.table, index + 1);
        const std::string which = index == 0 ? "" : fmt::format(", number {}", index + 1);
        plan_.modules.push_back({&manifest, instance,
                                 fmt::format("the scene has [{}]{}", manifest.table, which),
                                 std::move(options)});
    }

    void add_module(const Manifest& manifest, std::string reason) {
        const Node empty{Table{}, {path_, 0, 0}};
        plan_.modules.push_back({&manifest, manifest.id, std::move(reason),
                                 check_options(empty, manifest.options, paths_, plan_.faults)});
    }

    // Modules that no contract calls for: they wait for a request alone.
    void add_requested() {
        for (const Manifest& manifest : catalog_.manifests)
            if (manifest.table.empty() && manifest.provides.empty() && !manifest.when.empty() &&
                request_matches(manifest.when, request_))
                add_module(manifest, manifest.when == "recording"
                                         ? "frames or a video were asked for"
                                         : fmt::format("'{}' was asked for", manifest.when));
    }

    // What the request itself collects, of modules that find what they need in this plan.
    void add_collected() {
        for (const std::string& contract : request_.collects)
            for (const Manifest& manifest : catalog_.manifests)
                if (manifest.table.empty() && contains(manifest.provides, contract) &&
                    request_matches(manifest.when, request_) &&
                    std::all_of(manifest.needs.begin(), manifest.needs.end(),
                                [&](const std::string& need) { return planned(need); }))
                    add_module(manifest, fmt::format("{} is asked of all that provide it", contract));
    }

    bool planned(const std::string& contract) const {
        return std::any_of(plan_.modules.begin(), plan_.modules.end(),
                           [&](const PlannedModule& m) { return contains(m.manifest->provides, contract); });
    }

    // Modules without a table are drawn in by those that need what they provide; the list grows as it is read.
    void add_providers() {
        for (std::size_t i = 0; i < plan_.modules.size(); ++i) {
            const Manifest& consumer = *plan_.modules[i].manifest;
            for (const auto* wanted : {&consumer.needs, &consumer.uses})
                for (const std::string& contract : *wanted) {
                    if (planned(contract)) continue;
                    for (const Manifest& manifest : catalog_.manifests)
                        if (manifest.table.empty() && contains(manifest.provides, contract) &&
                            request_matches(manifest.when, request_))
                            add_module(manifest,
                                       fmt::format("{} {} {}", consumer.id,
                                                   wanted == &consumer.needs ? "needs" : "uses", contract));
                }
        }
    }

    // Nothing needs a window: it is the request that asks for one, and a scene that draws that brings it.
    void check_window() {
        const auto shows = [](const PlannedModule& m) { return m.manifest->when == "window"; };
        if (!request_.window || std::any_of(plan_.modules.begin(), plan_.modules.end(), shows)) return;
        std::string remedy;
        for (const Manifest& canvas : catalog_.manifests)
            for (const Manifest& drawer : catalog_.manifests)
                if (canvas.when == "window" && !drawer.table.empty() && wants(drawer, canvas))
                    remedy = fmt::format("add [{}] to the scene", drawer.table);
        plan_.faults.push_back({{path_, 0, 0},
                                "a window was asked for (--window), and nothing in this plan draws into one",
                                "",
                                remedy});
    }

    void check_contracts() {
        for (const PlannedModule& module : plan_.modules)
            for (const std::string& contract : module.manifest->provides)
                providers_[contract].push_back(module.instance);
        for (const PlannedModule& consumer : plan_.modules) {
            for (const std::string& contract : consumer.manifest->needs)
                check_providers(consumer, contract, true);
            for (const std::string& contract : consumer.manifest->uses)
                check_providers(consumer, contract, false);
        }
    }

    void check_providers(const PlannedModule& consumer, const std::string& contract, bool needed) {
        const std::vector<std::string>& names = providers_[contract];
        if (names.size() > 1)
            plan_.faults.push_back({{path_, 0, 0},
                                    fmt::format("'{}' takes {} from one module, and {} provide it",
                                                consumer.instance, contract, join_names(names, " and ")),
                                    "one provider",
                                    "leave one of them out"});
        if (!names.empty() || !needed) return;
        std::string remedy;
        for (const Manifest& manifest : catalog_.manifests)
            if (contains(manifest.provides, contract))
                remedy += fmt::format("{}'{}' provides it{}", remedy.empty() ? "" : "; ", manifest.id,
                                      manifest.table.empty()
                                          ? fmt::format(", but {}", request_missing(manifest.when))
                                          : fmt::format(": add [{}] to the scene", manifest.table));
        if (remedy.empty())
            remedy = fmt::format("no module in {} provides it", join_names(catalog_.directories, ", "));
        plan_.faults.push_back(
            {{path_, 0, 0},
             fmt::format("'{}' needs {}, which nothing in this plan provides", consumer.instance, contract),
             "",
             remedy});
    }

    // A picture is of a frame: there are no more of them.
    void check_rate() {
        const double asked = request_.frames_per_second;
        const double most = plan_.scene.step > 0 ? 1 / plan_.scene.step : asked;
        if (asked > most * (1 + 1e-9))
            plan_.faults.push_back(
                {{"--fps", 0, 0},
                 fmt::format("{:.6g} pictures a second of {:.6g} frames a second", asked, most),
                 fmt::format("at most {:.6g}", most),
                 "leave it out, or make --step smaller"});
    }

    void sort_modules() {
        AttachOrder order = attach_order(std::move(plan_.modules));
        plan_.modules = std::move(order.modules);
        if (order.circle.empty()) return;
        plan_.faults.push_back(
            {{path_, 0, 0},
             fmt::format("{} need each other in a circle", join_names(order.circle, " and ")),
             "providers that come before their consumers",
             "leave one of them out"});
    }

    void list_left_out() {
        for (const Manifest& manifest : catalog_.manifests) {
            const bool loaded = std::any_of(plan_.modules.begin(), plan_.modules.end(),
                                            [&](const PlannedModule& m) { return m.manifest == &manifest; });
            if (!loaded) plan_.left_out.push_back({&manifest, left_out_reason(manifest)});
        }
    }

    std::string left_out_reason(const Manifest& manifest) const {
        const bool asked = std::find(unasked_.begin(), unasked_.end(), &manifest) != unasked_.end();
        if (!manifest.table.empty() && !asked) return fmt::format("the scene has no [{}]", manifest.table);
        if (!request_matches(manifest.when, request_)) return request_missing(manifest.when);
        return "nothing in this plan needs it";
    }

    const Node& scene_;
    const std::string& path_;
    const Catalog& catalog_;
    const Request& request_;
    AssetPaths paths_;
    Plan plan_;
    std::map<std::string, std::vector<std::string>> providers_;  // instances, by contract
    std::vector<const Manifest*> unasked_;
};

}  // namespace

Plan make_plan(const Node& scene, const std::string& path, const Catalog& catalog, const Request& request) {
    return Planner(scene, path, catalog, request).make();
}

}  // namespace orbweaver
