#pragma once

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "program.hpp"
#include "shipped_scenes.hpp"

namespace orbweaver {

/// SOME PIG's scene with other lines in place of its text, baked.
inline std::string written_otherwise(const Folder& folder, const std::string& lines) {
    std::ifstream file(scene_path("some_pig"));
    std::string scene{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string text = "text = \"SOME PIG\"";
    scene.replace(scene.find(text), text.size(), lines);
    const std::string path = folder.write("scene.toml", scene);
    const std::string bake = std::string(ORBWEAVER_ASSETS_PROGRAM) + " bake '" + path + "' > /dev/null 2>&1";
    REQUIRE(std::system(bake.c_str()) == 0);
    return path;
}

}  // namespace orbweaver
