#pragma once

#include <string>
#include <vector>

#include "orbweaver/module.hpp"
#include "plan/catalog.hpp"
#include "plan/option_check.hpp"

namespace orbweaver {

/// One module instance that a run loads.
struct PlannedModule {
    const Manifest* manifest = nullptr;
    std::string instance;  ///< "web", "web.2", ...
    std::string reason;
    Options options;
};

struct LeftOut {
    const Manifest* manifest = nullptr;
    std::string reason;
};

/// What a run loads and what it leaves out. Points into the catalog it was made from.
struct Plan {
    SceneInfo scene;
    std::vector<PlannedModule> modules;  ///< in attach order: providers before consumers, ties by name
    std::vector<LeftOut> left_out;       ///< by id
    Diagnostics faults;                  ///< empty: the plan can be run
};

/// A pure function of scene, manifests and request (options that name files are looked up): finds every
/// fault at once and runs no module code. `path` is the scene's file.
Plan make_plan(const Node& scene, const std::string& path, const Catalog& catalog, const Request& request);

/// The plan for a person.
std::string plan_text(const Plan& plan);
/// The plan for a program.
std::string plan_json(const Plan& plan);

}  // namespace orbweaver
