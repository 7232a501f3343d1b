#pragma once

#include "plan/plan.hpp"
#include "scene/toml_reader.hpp"
#include "support/folder.hpp"

namespace orbweaver::test {

/// A folder with manifests and nothing else: planning must need no more.
class ManifestFolder {
public:
    /// `id` and what stands behind it, such as "table = \"web\"\nneeds = [\"wind/1\"]".
    void add(const std::string& id, const std::string& rest) const {
        folder_.write(id + ".toml", "id = \"" + id + "\"\nversion = \"1\"\n" + rest + "\n");
    }
    std::string path() const { return folder_.path(); }
    Catalog catalog() const { return read_catalog({folder_.path()}); }

private:
    Folder folder_;
};

/// A plan with the catalog that it points into.
struct Planned {
    Catalog catalog;
    Plan plan;

    Planned(Catalog modules, const std::string& scene, const Request& request = {})
        : catalog(std::move(modules)),
          plan(make_plan(read_toml_text(scene, "scene.toml"), "scene.toml", catalog, request)) {}

    /// "instance: reason" of every module, in order.
    std::vector<std::string> loaded() const {
        std::vector<std::string> all;
        for (const PlannedModule& module : plan.modules) all.push_back(module.instance + ": " + module.reason);
        return all;
    }
    std::vector<std::string> left_out() const {
        std::vector<std::string> all;
        for (const LeftOut& each : plan.left_out) all.push_back(each.manifest->id + ": " + each.reason);
        return all;
    }
    std::vector<std::string> faults() const {
        std::vector<std::string> all;
        for (const Diagnostic& fault : plan.faults) all.push_back(to_string(fault));
        return all;
    }
};

}  // namespace orbweaver::test
