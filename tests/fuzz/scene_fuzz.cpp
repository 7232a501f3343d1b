#include <filesystem>

#include "orbweaver/fault.hpp"
#include "plan/plan.hpp"
#include "scene/toml_reader.hpp"

using namespace orbweaver;

namespace {

/// The modules that we ship, by their manifests alone.
Catalog shipped_modules() {
    Catalog catalog;
    for (const auto& folder : std::filesystem::directory_iterator(ORBWEAVER_SOURCE_DIR "/modules"))
        if (const auto path = folder.path() / "manifest.toml"; std::filesystem::exists(path))
            if (auto manifest = read_manifest(path.string(), catalog.faults))
                catalog.manifests.push_back(*manifest);
    if (catalog.manifests.empty() || !catalog.faults.empty()) std::abort();
    return catalog;
}

}  // namespace

// A scene is refused with a Fault or planned, faults and all; anything else is a defect.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Catalog catalog = shipped_modules();
    try {
        const Node scene = read_toml_text({reinterpret_cast<const char*>(data), size}, "scene.toml");
        Request request;
        request.pictures = true;
        plan_json(make_plan(scene, ORBWEAVER_SOURCE_DIR "/assets/scenes/scene.toml", catalog, request));
    } catch (const Fault&) {
    }
    return 0;
}
