#pragma once

#include <catch2/catch.hpp>
#include <string>

#include "plan/manifest.hpp"
#include "plan/option_check.hpp"
#include "scene/toml_reader.hpp"

namespace orbweaver::test {

inline Manifest manifest_of(const std::string& module) {
    Diagnostics faults;
    auto found = read_manifest(std::string(ORBWEAVER_MODULE_DIR) + "/" + module + ".toml", faults);
    REQUIRE(found);
    return *found;
}

/// A module's table of a scene, as text, checked as the program does.
inline Options checked_options(const Manifest& manifest, const std::string& table, Diagnostics& faults) {
    return check_options(read_toml_text(table, "scene.toml"), manifest.options,
                         {".", {std::string(ORBWEAVER_SOURCE_DIR) + "/assets"}}, faults);
}

}  // namespace orbweaver::test
