#include "plan/scene_table.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "orbweaver/fault.hpp"

namespace orbweaver {

namespace {

constexpr const char* kSceneManifest = R"(
id = "scene"
version = "1"
summary = "What holds for the whole scene"

[options.name]
type = "text"
meaning = "what reports call the scene; its file's name when absent"
[options.duration]
type = "number"
unit = "s"
default = 10
min = 0
max = 1e6
meaning = "how long a run lasts"
[options.step]
type = "number"
unit = "s"
default = "1/60 s"
above = 0
max = 1e5
meaning = "length of one frame; methods substep inside it"
[options.seed]
type = "integer"
default = 1
min = 0
meaning = "seed of every random stream"
[options.gravity]
type = "vector"
unit = "m/s^2"
default = [0, -9.81, 0]
meaning = "acceleration of free fall; y is up"
)";

constexpr double kMostFrames = 1e9;

const Manifest& scene_manifest() {
    static const Manifest manifest = [] {
        Diagnostics faults;
        auto parsed = parse_manifest(kSceneManifest, "the [scene] table", faults);
        if (!parsed) throw Fault(FaultKind::internal, to_string(faults.front()));
        return std::move(*parsed);
    }();
    return manifest;
}

}  // namespace

std::span<const OptionSpec> scene_options() { return scene_manifest().options; }

SceneInfo read_scene_table(const Node& scene, const std::string& path, Diagnostics& faults) {
    const Node empty{Table{}, {path, 0, 0}};
    const Node* table = find(*scene.table(), "scene");
    const std::size_t before = faults.size();
    const Options options = check_options(table != nullptr ? *table : empty, scene_options(), {}, faults);
    SceneInfo info;
    info.directory = std::filesystem::path(path).parent_path().string();
    if (info.directory.empty()) info.directory = ".";
    info.name = options.has("name") ? options.text("name") : std::filesystem::path(path).stem().string();
    if (faults.size() > before) return info;
    info.duration = options.number("duration");
    info.step = options.number("step");
    if (info.duration / info.step > kMostFrames)
        faults.push_back({options.where("step"),
                          fmt::format("{} s in frames of {} s are {:.3g} frames", info.duration, info.step,
                                      info.duration / info.step),
                          fmt::format("at most {:g}", kMostFrames), "take longer frames, or fewer"});
    info.seed = static_cast<std::uint64_t>(options.integer("seed"));
    info.gravity = options.vector("gravity");
    return info;
}

}  // namespace orbweaver
