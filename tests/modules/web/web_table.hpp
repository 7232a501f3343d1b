#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "orbweaver/options.hpp"
#include "plan/manifest.hpp"
#include "plan/option_check.hpp"
#include "scene/toml_reader.hpp"

namespace orbweaver::web::test {

inline const std::string kSource = ORBWEAVER_SOURCE_DIR;

/// What the host hands to the module for this table.
inline Options options_of(const std::string& table) {
    Diagnostics faults;
    const auto manifest = read_manifest(kSource + "/modules/web/manifest.toml", faults);
    REQUIRE(manifest);
    const AssetPaths paths{kSource + "/assets/scenes", {kSource + "/assets"}};
    Options options = check_options(read_toml_text(table, "scene.toml"), manifest->options, paths, faults);
    INFO((faults.empty() ? std::string() : to_string(faults.front())));
    REQUIRE(faults.empty());
    return options;
}

}  // namespace orbweaver::web::test
